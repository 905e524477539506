#include "report/section_plot.hpp"
#include "compare/comparison.hpp"
#include "compare/condition.hpp"
#include "compare/section.hpp"
#include "mesh/outline.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <sstream>

namespace towform {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> between_commas(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const std::size_t first = part.find_first_not_of(' '), last = part.find_last_not_of(' ');
    if (first != std::string::npos) parts.push_back(part.substr(first, last - first + 1));
  }
  return parts;
}

struct Ends {
  Vec2 from, to;
};

/// Of the section: what the case says, else from the middle of the blank to its corner with the largest x, y.
Ends ends_of(const RunRecord& run)
{
  Vec2 low{run.sheet.flat.points[0].x, run.sheet.flat.points[0].y}, high = low;
  for (const Vec3& p : run.sheet.flat.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Symmetry symmetry = run.run_case ? run.run_case->blank.symmetry : Symmetry::none;
  const bool half_x = symmetry == Symmetry::x || symmetry == Symmetry::quarter;
  const bool half_y = symmetry == Symmetry::y || symmetry == Symmetry::quarter;
  Ends ends{{half_x ? 0.0 : 0.5 * (low.x + high.x), half_y ? 0.0 : 0.5 * (low.y + high.y)}, high};
  if (!run.run_case) return ends;
  const ReportParameters& r = run.run_case->report;
  if (r.centre) ends.from = {r.centre->x, r.centre->y};
  if (r.from.size() == 2) ends.from = {r.from[0], r.from[1]};
  if (r.to.size() == 2) ends.to = {r.to[0], r.to[1]};
  return ends;
}

std::string shown(const Vec2& p) { return fmt::format("({:.4g}, {:.4g})", 1e3 * p.x, 1e3 * p.y); }

std::vector<SectionPiece> pieces_between(const RunRecord& run, const Ends& ends)
{
  for (const bool left : {true, false}) {
    auto pieces = cut_section(run.sheet.position, run.sheet.flat.triangles, ends.from, ends.to, left);
    if (!pieces.empty()) return pieces;
  }
  return {};
}

double shear_of(const RunRecord& run, const SectionPiece& piece, bool magnitudes)
{
  const double shear = run.sheet.shear[static_cast<std::size_t>(piece.element)];
  return magnitudes ? std::abs(shear) : shear;
}

/// Polar angle at the centre of a sphere, from the pole that the section starts at [deg].
double polar(const Vec3& p, const Vec3& centre, bool upwards)
{
  const Vec3 v = p - centre, pole{0.0, 0.0, upwards ? 1.0 : -1.0};
  return std::atan2(norm(cross(v, pole)), dot(v, pole)) * 180.0 / M_PI;
}

Plot along_section(const RunRecord& run)
{
  const Ends ends = ends_of(run);
  Plot plot{fmt::format("Shear along the section from {} to {} mm in plan", shown(ends.from), shown(ends.to)),
            "length over the sheet [mm]",
            "|shear angle| [°]",
            {},
            {}};
  PlotSeries sheet{"sheet", {}, false};
  for (const SectionPiece& piece : pieces_between(run, ends))
    sheet.points.emplace_back(500.0 * (piece.arc_from + piece.arc_to), shear_of(run, piece, true));
  plot.series.push_back(std::move(sheet));
  if (run.run_case) {
    const double locking = run.run_case->report.locking_angle * 180.0 / M_PI;
    plot.limits.push_back({fmt::format("locking {:.3g}°", locking), locking});
  }
  return plot;
}

class ReferencePlot {
public:
  explicit ReferencePlot(const RunRecord& run) : run_(run), wishes_(run.run_case->report)
  {
    PointTable table = read_points(wishes_.reference);
    std::vector<Condition> conditions;
    for (const std::string& text : between_commas(wishes_.where)) conditions.push_back(read_condition(text));
    std::vector<ColumnChoice> choices;
    for (const std::string& text : between_commas(wishes_.columns))
      choices.push_back(read_column_choice(text));
    keep_rows(table, conditions);
    const ReferencePoints reference = read_columns(table, choices);
    ComparisonOptions options;
    options.centre = wishes_.centre;
    options.mirror = wishes_.mirror;
    options.nodal = wishes_.nodal;
    const Ends ends = ends_of(run);
    options.to = ends.to;
    if (!wishes_.centre && !wishes_.from.empty()) options.from = ends.from;
    if (reference.of(PointRole::arc)) options.from = ends.from;
    if (!reference.of(PointRole::arc) && !reference.of(PointRole::polar)) options.to = options.from = {};
    comparison_ = compare(run.sheet, reference, options);
  }

  Plot plot()
  {
    const std::string of = wishes_.reference.filename().string();
    const bool outline = comparison_.kind == ComparisonKind::outline;
    Plot p;
    p.title = fmt::format("The sheet and {}: RMS {:.2g}{} over {} points", of,
                          outline ? 1e3 * comparison_.rms : comparison_.rms, outline ? " mm" : "°",
                          comparison_.compared);
    p.y_label = comparison_.magnitudes ? "|shear angle| [°]" : "shear angle [°]";
    switch (comparison_.kind) {
    case ComparisonKind::outline:
      plan(p);
      break;
    case ComparisonKind::field:
      values(p);
      break;
    case ComparisonKind::section:
    case ComparisonKind::sphere:
      line(p);
      break;
    }
    return p;
  }

private:
  void line(Plot& p) const
  {
    const bool sphere = comparison_.kind == ComparisonKind::sphere;
    const PointRole role = sphere ? PointRole::polar : PointRole::arc;
    const double scale = sphere ? 1.0 : 1e3;
    p.x_label = sphere ? "polar angle at the sphere's centre [°]" : "length over the sheet [mm]";
    PlotSeries sheet{"sheet", {}, false}, points{"reference", {}, true};
    double last = 0.0;
    for (const ComparedPoint& c : comparison_.points) {
      points.points.emplace_back(scale * c.reference[role], c.wanted);
      last = std::max(last, c.reference[role]);
    }
    const std::vector<SectionPiece> pieces = pieces_between(run_, ends_of(run_));
    for (const SectionPiece& piece : pieces) {
      const Vec3 middle = 0.5 * (piece.from + piece.to);
      const double at = sphere ? polar(middle, *wishes_.centre, pieces.front().from.z > wishes_.centre->z)
                               : 0.5 * (piece.arc_from + piece.arc_to);
      if (at <= 1.05 * last)
        sheet.points.emplace_back(scale * at, shear_of(run_, piece, comparison_.magnitudes));
    }
    p.series = {std::move(sheet), std::move(points)};
  }

  void values(Plot& p) const
  {
    p.x_label = "shear angle of the reference [°]";
    PlotSeries same{"equal", {}, false}, points{"sheet", {}, true};
    double low = 0.0, high = 0.0;
    for (const ComparedPoint& c : comparison_.points) {
      if (!c.computed) continue;
      points.points.emplace_back(c.wanted, *c.computed);
      low = std::min({low, c.wanted, *c.computed});
      high = std::max({high, c.wanted, *c.computed});
    }
    same.points = {{low, low}, {high, high}};
    p.series = {std::move(same), std::move(points)};
  }

  void plan(Plot& p) const
  {
    p.x_label = "x [mm]";
    p.y_label = "y [mm]";
    p.equal_scales = true;
    PlotSeries sheet{"sheet", {}, false}, points{"reference", {}, true};
    for (const std::array<int, 2>& edge : outline_edges(run_.sheet.flat.triangles)) {
      if (is_mirrored(edge)) continue;
      for (const int n : edge)
        sheet.points.emplace_back(1e3 * run_.sheet.position[n].x, 1e3 * run_.sheet.position[n].y);
      sheet.points.emplace_back(nothing, nothing);
    }
    for (const ComparedPoint& c : comparison_.points)
      points.points.emplace_back(1e3 * c.reference[PointRole::x], 1e3 * c.reference[PointRole::y]);
    p.series = {std::move(sheet), std::move(points)};
  }

  /// Whether an edge lies on a plane of symmetry, where the part goes on.
  [[nodiscard]] bool is_mirrored(const std::array<int, 2>& edge) const
  {
    const Symmetry symmetry = run_.run_case->blank.symmetry;
    const auto on = [&](double Vec3::*across) {
      constexpr double near = 1e-9; // m
      const std::vector<Vec3>& flat = run_.sheet.flat.points;
      return std::abs(flat[edge[0]].*across) < near && std::abs(flat[edge[1]].*across) < near;
    };
    const bool quarter = symmetry == Symmetry::quarter;
    return ((quarter || symmetry == Symmetry::x) && on(&Vec3::x)) ||
           ((quarter || symmetry == Symmetry::y) && on(&Vec3::y));
  }

  const RunRecord& run_;
  const ReportParameters& wishes_;
  Comparison comparison_;
};

} // namespace

Plot section_plot(const RunRecord& run, std::vector<std::string>& notes)
{
  if (run.run_case && !run.run_case->report.reference.empty()) {
    const auto note = [&](const std::string& why) {
      notes.push_back(
          fmt::format("the reference {} is not drawn: {}", run.run_case->report.reference.string(), why));
    };
    try {
      return ReferencePlot(run).plot();
    } catch (const InputError& e) {
      note(e.what());
    } catch (const FileError& e) {
      note(e.what());
    } catch (const std::invalid_argument& e) {
      note(e.what());
    }
  }
  return along_section(run);
}

} // namespace towform
