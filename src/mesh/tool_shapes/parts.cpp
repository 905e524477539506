#include "mesh/tool_shapes/parts.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform::shapes {

std::string millimetres(double length) { return fmt::format("{:.6g} mm", length * 1e3); }

Facets edge_facets(const Plan& plan, double radius, Along<double> curvature, double budget)
{
  constexpr double share_across = 0.6, longest = 2.5;
  Facets facets;
  facets.across = std::sqrt(8.0 * share_across * budget * radius);
  const auto along = [&](double k) {
    const double cap = longest * facets.across;
    return k > 0.0 ? std::min(cap, std::sqrt(8.0 * (1.0 - share_across) * budget / k)) : cap;
  };
  facets.along = {plan.has_middle() ? along(curvature.middle) : 0.0, along(curvature.dome)};
  return facets;
}

std::vector<Ring> rounded_edge(Quarter& quarter, const EdgeCurve& edge, double radius, const Vec3& end,
                               const Facets& facets)
{
  const double start = facets.along.middle > 0.0 ? 0.0 : 1.0;
  double widest = 0.0; // of the arc's angles, which differ along the edge
  constexpr int samples = 16;
  for (int i = 0; i <= samples; ++i)
    widest = std::max(widest, std::acos(-dot(edge(start + (2.0 - start) * i / samples).normal, end)));
  const int steps = std::max(3, static_cast<int>(std::ceil(widest * radius / facets.across)));
  const auto arc = [&](double f) -> Curve {
    return [&edge, &end, radius, f](double u) {
      const Edge e = edge(u);
      const double angle = std::acos(-dot(e.normal, end));
      return e.centre + (radius / std::sin(angle)) *
                            (std::sin(f * angle) * end - std::sin((1.0 - f) * angle) * e.normal);
    };
  };
  Along<int> n = intervals(arc(0.0), facets.along);
  const Along<int> last = intervals(arc(1.0), facets.along);
  n = {std::max(n.middle, last.middle), std::max(n.dome, last.dome)};
  std::vector<Ring> rings;
  rings.reserve(steps + 1);
  for (int i = 0; i < steps; ++i) rings.push_back(quarter.ring(arc(static_cast<double>(i) / steps), n));
  // The last ring is flat to the bit when `end` is vertical and the centres lie at one height.
  const Curve flat = [&](double u) { return edge(u).centre + radius * end; };
  rings.push_back(quarter.ring(flat, n));
  return rings;
}

SurfaceMesh punch(const Plan& plan, const DomeSurface& surface, double apex_z, double top, double chord_error)
{
  const double s_top = surface.s_at_rise(top);
  const double s_arc = std::min(surface.arc_end(), s_top);
  const double budget = chord_share * chord_error;
  const double step = std::sqrt(4.0 * budget * surface.radius); // both directions of a sphere take half
  const double k = surface.outline_curvature();
  const double middle_step = k > 0.0 ? std::min(2.0 * step, std::sqrt(4.0 * budget / k)) : 2.0 * step;
  const Along<double> along{plan.has_middle() ? middle_step : 0.0, step};
  const int arc_rings = std::max(4, static_cast<int>(std::ceil(s_arc * surface.radius / step)));
  const int wall_rings = static_cast<int>(std::ceil((s_top - s_arc) * surface.radius / (2.0 * step)));

  Quarter quarter;
  const auto level = [&](double s) -> Curve {
    return [&surface, apex_z, s](double u) { return surface.point(u, s) + Vec3{0.0, 0.0, apex_z}; };
  };
  // One count between the domes keeps the grid straight there.
  const int middle = plan.has_middle() ? intervals(level(s_arc), along).middle : 0;
  std::vector<Ring> rings;
  for (int i = wall_rings; i > 0; --i) {
    const Curve ring = level(std::lerp(s_arc, s_top, static_cast<double>(i) / wall_rings));
    rings.push_back(quarter.ring(ring, {middle, intervals(level(s_arc), along).dome}));
  }
  for (int i = arc_rings; i > 0; --i) {
    const Curve ring = level(std::lerp(0.0, s_arc, static_cast<double>(i) / arc_rings));
    rings.push_back(quarter.ring(ring, {middle, intervals(ring, along).dome}));
  }
  rings.push_back(plan.spine(quarter, apex_z, middle));
  quarter.loft(rings);

  // The cap is flat to the bit: its rim's height is the first ring's.
  const double cap_spacing = flat_spacing / 2.0, cap_z = level(s_top)(2.0).z;
  const Curve spine = plan.spine(cap_z), rim = level(s_top);
  std::vector<Ring> cap{rings.front()};
  for (const Ring& ring : plan.between(quarter, rim, spine, step, cap_spacing, false)) cap.push_back(ring);
  cap.push_back(plan.spine(quarter, cap_z, cap_spacing));
  std::reverse(cap.begin(), cap.end());
  quarter.loft(cap);
  return quarter.mirrored();
}

void check_flat_face(const Plan& plan, const Curve& inner, const std::string& what)
{
  double x = 0.0, y = 0.0;
  constexpr int samples = 256;
  const double start = plan.has_middle() ? 0.0 : 1.0;
  for (int i = 0; i <= samples; ++i) {
    const Vec3 p = inner(start + (2.0 - start) * i / samples);
    x = std::max(x, p.x);
    y = std::max(y, p.y);
  }
  constexpr double least = 5e-3; // of flat face
  if (x + least > plan.half_length)
    throw std::invalid_argument(
        fmt::format("flange-length = {} leaves no flat face: {} reaches {} from the middle",
                    millimetres(2.0 * plan.half_length), what, millimetres(x)));
  if (y + least > plan.half_width)
    throw std::invalid_argument(
        fmt::format("flange-width = {} leaves no flat face: {} reaches {} from the middle",
                    millimetres(2.0 * plan.half_width), what, millimetres(y)));
}

SurfaceMesh holder(const Plan& plan, const EdgeCurve& flange_start, const HolderSizes& sizes)
{
  if (sizes.fillet >= sizes.thickness)
    throw std::invalid_argument(fmt::format("holder-fillet = {} does not fit into holder-thickness = {}",
                                            millimetres(sizes.fillet), millimetres(sizes.thickness)));
  const double top_z = sizes.underside_z + sizes.thickness;
  const EdgeCurve edge = [&](double u) {
    const Edge start = flange_start(u);
    const Vec3 out = normalized({start.normal.x, start.normal.y, 0.0});
    Vec3 centre = start.centre + (sizes.clearance + sizes.fillet) * out;
    centre.z = sizes.underside_z + sizes.fillet;
    return Edge{centre, out};
  };
  const Curve underside = [&](double u) {
    const Vec3 p = edge(u).centre;
    return Vec3{p.x, p.y, sizes.underside_z};
  };
  const auto wall = [&](double z) -> Curve {
    return [&edge, &sizes, z](double u) {
      const Edge e = edge(u);
      return Vec3{e.centre.x - sizes.fillet * e.normal.x, e.centre.y - sizes.fillet * e.normal.y, z};
    };
  };
  check_flat_face(plan, underside, "the holder's rounded edge");
  constexpr int samples = 256;
  for (int i = 1; plan.has_middle() && i <= samples; ++i)
    if (underside(static_cast<double>(i) / samples).x <= underside((i - 1.0) / samples).x)
      throw std::invalid_argument(fmt::format(
          "holder-clearance + holder-fillet = {} folds the holder's opening over beside the waist",
          millimetres(sizes.clearance + sizes.fillet)));

  Quarter quarter;
  const Facets facets = edge_facets(plan, sizes.fillet, sizes.curvature, chord_share * sizes.chord_error);
  std::vector<Ring> edge_rings = rounded_edge(quarter, edge, sizes.fillet, {0.0, 0.0, -1.0}, facets);
  std::reverse(edge_rings.begin(), edge_rings.end()); // from the underside up to the wall
  const double fine = facets.along.dome;
  const auto add = [](std::vector<Ring>& to, const std::vector<Ring>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  std::vector<Ring> rings{plan.rim(quarter, sizes.underside_z, flat_spacing)};
  add(rings, plan.between(quarter, plan.rectangle(sizes.underside_z), underside, flat_spacing, fine, true));
  add(rings, edge_rings);
  const double wall_height = sizes.thickness - sizes.fillet;
  const int wall_rings = static_cast<int>(std::ceil(wall_height / (2.0 * fine)));
  const Along<int> n{static_cast<int>(edge_rings.back().join),
                     static_cast<int>(edge_rings.back().nodes.size() - 1 - edge_rings.back().join)};
  for (int i = 1; i < wall_rings; ++i)
    rings.push_back(quarter.ring(wall(sizes.underside_z + sizes.fillet + wall_height * i / wall_rings), n));
  rings.push_back(quarter.ring(wall(top_z), n));
  add(rings, plan.between(quarter, wall(top_z), plan.rectangle(top_z), fine, flat_spacing, true));
  rings.push_back(plan.rim(quarter, top_z, flat_spacing));
  rings.push_back(rings.front());
  quarter.loft(rings);
  return quarter.mirrored();
}

} // namespace towform::shapes
