#include "report/verdict.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace towform {

namespace {

using Grade = Finding::Grade;

constexpr double inertia_matters = 0.1;      ///< kinetic over internal energy, as the run itself says
constexpr double compression_matters = 0.01; ///< fraction of elements, likewise
constexpr double near = 0.5;                 ///< of a gate: worth a look

Finding ending(const RunRecord& run)
{
  const std::string status = run.summary.value("status", "");
  const std::string message = run.summary.value("message", "");
  if (run.goes_on) // whatever an earlier run left as its summary
    return {Grade::watch,
            fmt::format("The run goes on: what is shown ends at {:.4g}{} ms.", 1e3 * run.sheet.time,
                        run.run_case ? fmt::format(" of {:.4g}", 1e3 * run.run_case->time.end) : "")};
  if (status == "done") return {Grade::good, "The run went to its end."};
  if (status == "preview")
    return {Grade::watch, "A preview: sheet and tools as they start. Nothing has been computed."};
  if (status.empty())
    return {Grade::watch,
            fmt::format("The run was killed: what is shown ends at {:.4g} ms.", 1e3 * run.sheet.time)};
  return {status == "interrupted" ? Grade::watch : Grade::bad,
          fmt::format("The run did not go to its end: {}.", message.empty() ? status : message)};
}

/// The share of the blank's elements over an angle [deg].
double share_over(const RunRecord& run, double angle)
{
  const auto over = std::count_if(run.sheet.shear.begin(), run.sheet.shear.end(),
                                  [&](double shear) { return std::abs(shear) > angle; });
  return static_cast<double>(over) / static_cast<double>(run.sheet.shear.size());
}

Finding locking(const RunRecord& run)
{
  double most = 0.0;
  std::size_t where = 0;
  for (std::size_t e = 0; e < run.sheet.shear.size(); ++e)
    if (std::abs(run.sheet.shear[e]) > most) {
      most = std::abs(run.sheet.shear[e]);
      where = e;
    }
  Vec3 centre;
  for (const int n : run.sheet.flat.triangles[where]) centre += (1.0 / 3.0) * run.sheet.flat.points[n];
  const double limit = run.run_case->report.locking_angle * 180.0 / M_PI;
  const bool is_default = std::abs(limit - 60.0) < 1e-6; // a resolved case gives every key
  const std::string place = fmt::format("element {}, x = {:.0f}, y = {:.0f} mm on the flat blank", where,
                                        1e3 * centre.x, 1e3 * centre.y);
  const std::string of =
      fmt::format("the locking angle of {:.3g}°{}", limit,
                  is_default ? " (the default: typical of twills, not measured on this sheet)" : "");
  const bool specimen = run.run_case->tools.empty(); // sheared past locking on purpose
  if (most > limit)
    return {specimen ? Grade::watch : Grade::bad,
            fmt::format("Shear reaches {:.1f}° ({}), past {}: {:.1f} % of the elements are beyond it, and a "
                        "real sheet is likely to wrinkle there.",
                        most, place, of, 100.0 * share_over(run, limit))};
  constexpr double close = 5.0;
  return {most > limit - close ? Grade::watch : Grade::good,
          fmt::format("Shear reaches {:.1f}° ({}), {:.1f}° below {}.", most, place, limit - most, of)};
}

/// A figure of the summary against a gate; both as they are shown. Nothing without the figure.
void gate(std::vector<Finding>& list, double value, double limit, const char* words, const char* units,
          const char* after)
{
  if (!std::isfinite(value)) return;
  const Grade grade = value > limit ? Grade::bad : value > near * limit ? Grade::watch : Grade::good;
  list.push_back({grade, fmt::format("{} {:.3g} {}{}, {} the gate of {:.3g} {}.", words, value, units, after,
                                     value > limit ? "past" : "within", limit, units)});
}

} // namespace

std::vector<Finding> verdict(const RunRecord& run)
{
  std::vector<Finding> list{ending(run)};
  if (run.is_preview()) return list;
  if (run.run_case) {
    const GateParameters& gates = run.run_case->gates;
    list.push_back(locking(run));
    gate(list, 100.0 * run.figure("energy_error"), 100.0 * gates.energy_error,
         "The account of energies is off by", "%", " of the external work");
    if (!run.run_case->tools.empty())
      gate(list, run.figure("penetration_max_mm"), 1e3 * gates.penetration, "The sheet went at most", "mm",
           " into a tool");
    gate(list, 100.0 * run.figure("fibre_strain_p99"), 100.0 * gates.yarn_strain,
         "In 99 % of the elements yarns strain by at most", "%", "");
  }
  if (const double kinetic = run.figure("kinetic_to_internal_max"); kinetic > 0.0) // 0: not that far
    list.push_back(
        {kinetic > inertia_matters ? Grade::watch : Grade::good,
         fmt::format("In the second half of the run kinetic energy reached {:.1f} % of internal and "
                     "dissipated energy: {}.",
                     100.0 * kinetic,
                     kinetic > inertia_matters ? "inertia shapes the answer, as it does in a fast press"
                                               : "inertia hardly matters")});
  if (const double hidden = run.figure("fibre_compression_over_half_percent"); hidden > compression_matters)
    list.push_back(
        {Grade::watch,
         fmt::format("{:.1f} % of the elements shorten their yarns by more than 0.5 % (up to {:.1f} %), "
                     "where a real sheet buckles: look at yarn strain, curvature and clearance.",
                     100.0 * hidden, 100.0 * run.figure("fibre_compression_max"))});
  return list;
}

Grade worst(const std::vector<Finding>& findings)
{
  Grade grade = Grade::good;
  for (const Finding& f : findings) grade = std::max(grade, f.grade);
  return grade;
}

std::vector<std::string> warnings_of(const std::string& log)
{
  std::vector<std::string> list;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    for (const char* start : {"strip_stiffness locks:", "flat elements:", "the checkpoint was written by",
                              "inertia matters:", "compression hides wrinkles:"})
      if (const std::size_t at = line.find(start); at != std::string::npos) list.push_back(line.substr(at));
  }
  return list;
}

} // namespace towform
