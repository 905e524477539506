#include "mesh/tool_shapes/parts.hpp"
#include "mesh/tool_shapes/values.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform::shapes {

namespace {

struct DoubleDome {
  DomeSurface surface;
  Plan plan;
  double depth, gap, fillet, skirt, base, sheet, chord_error;
  double dome_fillet_start; ///< the same all round a dome, so found once

  [[nodiscard]] double apex_start() const { return sheet / 2.0; }
  [[nodiscard]] double apex_closed() const { return sheet / 2.0 - depth; }
  [[nodiscard]] double flange_z() const { return -sheet / 2.0; }
  [[nodiscard]] Vec3 offset(double u, double s, double distance) const
  {
    return surface.point(u, s) + distance * surface.normal(u, s) + Vec3{0.0, 0.0, apex_closed()};
  }
  [[nodiscard]] double solve_fillet_start(double u) const;
  [[nodiscard]] double fillet_start(double u) const
  {
    return u < 1.0 ? solve_fillet_start(u) : dome_fillet_start;
  }
  [[nodiscard]] Edge flange_edge(double u) const;
};

/// The s at which a ball of the fillet's radius, rolling on the cavity's far side, touches the flange's
/// plane.
double DoubleDome::solve_fillet_start(double u) const
{
  const auto too_high = [&](double s) { return offset(u, s, gap + fillet).z > flange_z() - fillet; };
  double low = 0.0, high = surface.s_at_rise(depth + gap + fillet);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (too_high(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Centre of that ball and the punch's normal through it.
Edge DoubleDome::flange_edge(double u) const
{
  const double s = fillet_start(u);
  Vec3 centre = offset(u, s, gap + fillet);
  centre.z = flange_z() - fillet;
  return {centre, surface.normal(u, s)};
}

void check(const DoubleDome& d)
{
  if (d.surface.waist > d.surface.radius)
    throw std::invalid_argument(fmt::format("waist-half-width = {} is more than dome-radius = {}",
                                            millimetres(d.surface.waist), millimetres(d.surface.radius)));
  if (d.gap < d.sheet)
    throw std::invalid_argument(
        fmt::format("gap = {} is less than sheet-thickness = {}", millimetres(d.gap), millimetres(d.sheet)));
  if (d.depth <= d.sheet + d.fillet)
    throw std::invalid_argument(
        fmt::format("depth = {} leaves no wall beside entry-fillet = {} and sheet-thickness = {}",
                    millimetres(d.depth), millimetres(d.fillet), millimetres(d.sheet)));
  const double concave = d.surface.concave_curvature(d.surface.s_at_rise(d.depth + d.skirt));
  if (concave * (d.gap + d.fillet) >= 0.95)
    throw std::invalid_argument(fmt::format("gap + entry-fillet = {} do not fit into the waist, whose "
                                            "smallest concave radius is {} (dome-radius = {}, "
                                            "waist-half-width = {}, dome-distance = {})",
                                            millimetres(d.gap + d.fillet), millimetres(1.0 / concave),
                                            millimetres(d.surface.radius), millimetres(d.surface.waist),
                                            millimetres(2.0 * d.surface.centre)));
}

/// A long skirt with much draft would be wider than the holder's opening.
void check_punch_clears_holder(const DoubleDome& d, double thickness, double clearance)
{
  const double s = d.surface.s_at_rise(d.depth + std::min(d.skirt, thickness));
  const double punch_x = d.offset(2.0, s, 0.0).x, punch_y = d.offset(0.0, s, 0.0).y;
  const double opening_x = d.flange_edge(2.0).centre.x + clearance;
  const double opening_y = d.flange_edge(0.0).centre.y + clearance;
  if (punch_x >= opening_x || punch_y >= opening_y)
    throw std::invalid_argument(fmt::format(
        "the closed punch, {} x {} at the holder's height, does not pass its opening of {} x {} (half "
        "sizes): less "
        "draft, skirt or holder-thickness, or more gap, entry-fillet or holder-clearance",
        millimetres(punch_x), millimetres(punch_y), millimetres(opening_x), millimetres(opening_y)));
}

SurfaceMesh die(const DoubleDome& d)
{
  const EdgeCurve edge = [&](double u) { return d.flange_edge(u); };
  const Curve flange_start = [&](double u) {
    const Vec3 p = edge(u).centre;
    return Vec3{p.x, p.y, d.flange_z()};
  };
  check_flat_face(d.plan, flange_start, "the entry fillet");
  const double budget = chord_share * d.chord_error;
  const double outline = d.surface.outline_curvature();

  // The cavity, in as many rings everywhere: s from 0 to the fillet's own start.
  const double stretch = d.surface.radius / d.surface.waist;
  const double radius = d.surface.radius + d.gap * stretch * stretch; // bounds the turning per s, see punch()
  const double turn = std::sqrt(4.0 * budget / radius);
  const double step = turn * (d.surface.radius + d.gap);
  const double middle = outline > 0.0 ? std::min(2.0 * step, std::sqrt(4.0 * budget / outline)) : 2.0 * step;
  double s_end = 0.0; // the largest
  for (int i = 0; i <= 16; ++i) s_end = std::max(s_end, d.fillet_start(i / 16.0));
  const int cavity_rings = std::max(4, static_cast<int>(std::ceil(s_end / turn)));
  const int columns = intervals(flange_start, {middle, step}).middle;
  Quarter quarter;
  std::vector<Ring> rings{d.plan.spine(quarter, d.apex_closed() - d.gap, columns)};
  for (int i = 1; i < cavity_rings; ++i) {
    const Curve level = [&, i](double u) { return d.offset(u, d.fillet_start(u) * i / cavity_rings, d.gap); };
    rings.push_back(quarter.ring(level, {columns, intervals(level, {middle, step}).dome}));
  }
  const auto add = [&rings](const std::vector<Ring>& more) {
    rings.insert(rings.end(), more.begin(), more.end());
  };
  const double wall_radius = edge(2.0).centre.x - d.plan.centre - d.fillet;
  const Facets facets = edge_facets(d.plan, d.fillet, {outline, 1.0 / wall_radius}, budget);
  add(rounded_edge(quarter, edge, d.fillet, {0.0, 0.0, 1.0}, facets));
  add(d.plan.between(quarter, flange_start, d.plan.rectangle(d.flange_z()), facets.along.dome, flat_spacing,
                     true));

  const double bottom = d.apex_closed() - d.gap - d.base;
  rings.push_back(d.plan.rim(quarter, d.flange_z(), flat_spacing));
  rings.push_back(d.plan.rim(quarter, bottom, flat_spacing));
  add(d.plan.between(quarter, d.plan.rectangle(bottom), d.plan.spine(bottom), flat_spacing, flat_spacing,
                     true));
  rings.push_back(d.plan.spine(quarter, bottom, flat_spacing));
  quarter.loft(rings);
  return quarter.mirrored();
}

} // namespace

SurfaceMesh build_double_dome(const std::string& part, const Values& v)
{
  DoubleDome d{};
  d.surface = {v["dome-radius"], v["waist-half-width"], v["dome-distance"] / 2.0, v["draft"]};
  d.plan = {v["flange-length"] / 2.0, v["flange-width"] / 2.0, d.surface.centre};
  d.depth = v["depth"];
  d.gap = v["gap"];
  d.fillet = v["entry-fillet"];
  d.skirt = v["skirt"];
  d.base = v["base"];
  d.sheet = v["sheet-thickness"];
  d.chord_error = v["chord-error"];
  d.dome_fillet_start = d.solve_fillet_start(1.0);
  check(d); // whatever the part: the three must match
  if (part == "punch") return punch(d.plan, d.surface, d.apex_start(), d.depth + d.skirt, d.chord_error);
  if (part == "die") return die(d);

  const EdgeCurve edge = [&](double u) { return d.flange_edge(u); };
  check_punch_clears_holder(d, v["holder-thickness"], v["holder-clearance"]);
  const double dome_radius = edge(2.0).centre.x - d.surface.centre;
  return holder(d.plan, edge,
                {.underside_z = d.sheet / 2.0,
                 .thickness = v["holder-thickness"],
                 .clearance = v["holder-clearance"],
                 .fillet = v["holder-fillet"],
                 .curvature = {d.surface.outline_curvature(), 1.0 / dome_radius},
                 .chord_error = d.chord_error});
}

} // namespace towform::shapes
