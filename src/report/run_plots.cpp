#include "report/run_plots.hpp"
#include "report/section_plot.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

using Column = std::vector<double>;

/// What plots have along x: the stroke of the first thing that is driven, or time.
struct Progression {
  std::string label;
  Column values;
};

Progression progression(const RunRecord& run)
{
  const Column& time = run.history.at("time_s");
  if (run.run_case) {
    const auto stroke = [&](const auto& driven) -> std::optional<Progression> {
      for (const auto& d : driven)
        if (const auto found = run.history.find(fmt::format("position_{}_m", d.name));
            d.motion && found != run.history.end()) {
          Progression p{fmt::format("stroke of {} [mm]", d.name), {}};
          for (const double x : found->second) p.values.push_back(1e3 * std::abs(x));
          return p;
        }
      return std::nullopt;
    };
    if (auto p = stroke(run.run_case->tools)) return *p;
    if (auto p = stroke(run.run_case->boundaries)) return *p;
  }
  Progression p{"time [ms]", {}};
  for (const double t : time) p.values.push_back(1e3 * t);
  return p;
}

PlotSeries curve(const std::string& label, const Column& x, const Column& y, double factor = 1.0)
{
  PlotSeries s{label, {}, false};
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) s.points.emplace_back(x[i], factor * y[i]);
  return s;
}

std::string words(std::string name)
{
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// A series for each of the columns `prefix…suffix` that is not zero throughout.
std::vector<PlotSeries> curves_between(const RunRecord& run, const Column& x, const std::string& prefix,
                                       const std::string& suffix)
{
  std::vector<PlotSeries> list;
  for (const auto& [name, values] : run.history) {
    if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() <= prefix.size() + suffix.size())
      continue;
    if (std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; })) continue;
    list.push_back(
        curve(words(name.substr(prefix.size(), name.size() - prefix.size() - suffix.size())), x, values));
  }
  return list;
}

Plot forces(const RunRecord& run, const Progression& p)
{
  return {"Forces on the tools", p.label, "force [N]", curves_between(run, p.values, "force_", "_N"), {}};
}

/// The largest first, and those that never matter left out: eight at most can be told apart.
Plot energies(const RunRecord& run, const Progression& p)
{
  constexpr std::size_t most = 8;
  Plot plot{"Energies", p.label, "energy [J]", curves_between(run, p.values, "energy_", "_J"), {}};
  const auto largest = [](const PlotSeries& s) {
    double value = 0.0;
    for (const auto& point : s.points) value = std::max(value, std::abs(point.second));
    return value;
  };
  std::stable_sort(plot.series.begin(), plot.series.end(),
                   [&](const PlotSeries& a, const PlotSeries& b) { return largest(a) > largest(b); });
  if (plot.series.empty()) return plot;
  const double least = 2e-3 * largest(plot.series.front());
  std::erase_if(plot.series, [&](const PlotSeries& s) { return largest(s) < least; });
  if (plot.series.size() > most) plot.series.resize(most);
  return plot;
}

Plot energy_error(const RunRecord& run, const Progression& p)
{
  Plot plot{"Energy error over external work", p.label, "error [%]", {}, {}};
  const auto error = run.history.find("energy_error");
  if (error == run.history.end()) return plot;
  plot.series.push_back(curve("error", p.values, error->second, 100.0));
  // In the first quarter the work is small and its ratio says nothing; the gate looks later too.
  const Column& time = run.history.at("time_s");
  if (!time.empty() && time.back() > 0.0)
    for (std::size_t i = 0; i < plot.series.front().points.size(); ++i)
      if (time[i] < 0.02 * time.back()) plot.series.front().points[i].second = NAN;
  if (run.run_case) plot.limits.push_back({"gate", 100.0 * run.run_case->gates.energy_error});
  return plot;
}

Plot draw_in(const RunRecord& run, const Progression& p)
{
  Plot plot{"Draw-in of the blank's edge", p.label, "draw-in [mm]", {}, {}};
  for (const auto& [column, label] : {std::pair{"draw_in_x_mid_mm", "middle, along x"},
                                      {"draw_in_y_mid_mm", "middle, along y"},
                                      {"draw_in_corner_mm", "corner"}})
    if (const auto found = run.history.find(column); found != run.history.end())
      plot.series.push_back(curve(label, p.values, found->second));
  return plot;
}

double area(const SheetResult& sheet, std::size_t element)
{
  const auto& [a, b, c] = sheet.flat.triangles[element];
  const auto& x = sheet.flat.points;
  return 0.5 * norm(cross(x[b] - x[a], x[c] - x[a]));
}

Plot histogram(const RunRecord& run)
{
  Plot plot{"How much of the blank is sheared how far",
            "|shear angle| [°]",
            "share of the blank [%]",
            {},
            {},
            true};
  const SheetResult& sheet = run.sheet;
  double most = 0.0, total = 0.0;
  for (const double angle : sheet.shear) most = std::max(most, std::abs(angle));
  const std::vector<double> ticks = round_ticks(0.0, std::max(most, 1.0), 6);
  const double bin = (ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0) / 5.0;
  const auto bins = static_cast<std::size_t>(std::floor(most / bin)) + 1;
  Column share(bins, 0.0);
  for (std::size_t e = 0; e < sheet.shear.size(); ++e) {
    const double a = area(sheet, e);
    total += a;
    share[static_cast<std::size_t>(std::abs(sheet.shear[e]) / bin)] += a;
  }
  PlotSeries bars{"share", {}, false};
  for (std::size_t b = 0; b <= bins; ++b)
    bars.points.emplace_back(static_cast<double>(b) * bin, b < bins ? 100.0 * share[b] / total : 0.0);
  plot.series.push_back(std::move(bars));
  if (run.run_case) {
    const double locking = run.run_case->report.locking_angle * 180.0 / M_PI;
    plot.limits.push_back({fmt::format("locking {:.3g}°", locking), locking, true});
  }
  return plot;
}

} // namespace

std::vector<Plot> run_plots(const RunRecord& run, std::vector<std::string>& notes)
{
  std::vector<Plot> plots;
  if (run.has("time_s")) {
    const Progression p = progression(run);
    plots = {forces(run, p), draw_in(run, p), energies(run, p), energy_error(run, p)};
  }
  plots.push_back(histogram(run));
  plots.push_back(section_plot(run, notes));
  std::erase_if(plots, [](const Plot& plot) { return plot.empty(); });
  return plots;
}

} // namespace towform
