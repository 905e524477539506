#include "mesh/tool_shapes/parts.hpp"
#include "mesh/tool_shapes/values.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform::shapes {

namespace {

struct Hemisphere {
  Plan plan;
  double radius, opening, depth, fillet, skirt, thickness, sheet, chord_error;

  /// The fillet's ball: it rolls round the opening, touching the wall and the flange.
  [[nodiscard]] Edge flange_edge(double u) const
  {
    const double angle = (2.0 - u) * std::numbers::pi / 2.0;
    const Vec3 out{std::cos(angle), std::sin(angle), 0.0};
    return {(opening + fillet) * out + Vec3{0.0, 0.0, -sheet / 2.0 - fillet}, out};
  }
};

void check(const Hemisphere& h)
{
  if (h.opening < h.radius + h.sheet)
    throw std::invalid_argument(
        fmt::format("opening-radius = {} is less than dome-radius = {} and sheet-thickness = {} together",
                    millimetres(h.opening), millimetres(h.radius), millimetres(h.sheet)));
  if (h.thickness <= h.fillet)
    throw std::invalid_argument(fmt::format("die-thickness = {} leaves no wall below entry-fillet = {}",
                                            millimetres(h.thickness), millimetres(h.fillet)));
}

SurfaceMesh die(const Hemisphere& h)
{
  const double top = -h.sheet / 2.0, bottom = top - h.thickness;
  const EdgeCurve edge = [&](double u) { return h.flange_edge(u); };
  const auto circle = [&](double radius, double z) -> Curve {
    return [&edge, radius, z](double u) {
      const Vec3 out = edge(u).normal;
      return Vec3{radius * out.x, radius * out.y, z};
    };
  };
  const Curve flange_start = circle(h.opening + h.fillet, top), foot = circle(h.opening, bottom);
  check_flat_face(h.plan, flange_start, "the entry fillet");

  Quarter quarter;
  const Facets facets = edge_facets(h.plan, h.fillet, {0.0, 1.0 / h.opening}, chord_share * h.chord_error);
  const double fine = facets.along.dome;
  std::vector<Ring> rings;
  const auto add = [&rings](const std::vector<Ring>& more) {
    rings.insert(rings.end(), more.begin(), more.end());
  };
  const std::vector<Ring> rounded = rounded_edge(quarter, edge, h.fillet, {0.0, 0.0, 1.0}, facets);
  const Along<int> n{0, static_cast<int>(rounded.front().nodes.size()) - 1};
  const double wall = h.thickness - h.fillet;
  const int wall_rings = static_cast<int>(std::ceil(wall / (2.0 * fine)));
  for (int i = 0; i < wall_rings; ++i)
    rings.push_back(quarter.ring(circle(h.opening, bottom + wall * i / wall_rings), n));
  const Ring first = rings.front();
  add(rounded);
  add(h.plan.between(quarter, flange_start, h.plan.rectangle(top), fine, flat_spacing, true));
  rings.push_back(h.plan.rim(quarter, top, flat_spacing));
  rings.push_back(h.plan.rim(quarter, bottom, flat_spacing));
  add(h.plan.between(quarter, h.plan.rectangle(bottom), foot, flat_spacing, fine, true));
  rings.push_back(first);
  quarter.loft(rings);
  return quarter.mirrored();
}

} // namespace

SurfaceMesh build_hemisphere(const std::string& part, const Values& v)
{
  Hemisphere h{};
  h.plan = {v["flange-length"] / 2.0, v["flange-width"] / 2.0, 0.0};
  h.radius = v["dome-radius"];
  h.opening = v["opening-radius"];
  h.depth = v["depth"];
  h.fillet = v["entry-fillet"];
  h.skirt = v["skirt"];
  h.thickness = v["die-thickness"];
  h.sheet = v["sheet-thickness"];
  h.chord_error = v["chord-error"];
  check(h); // whatever the part: the three must match
  if (part == "punch") {
    const DomeSurface sphere{.radius = h.radius, .waist = h.radius, .centre = 0.0, .draft = 0.0};
    return punch(h.plan, sphere, h.sheet / 2.0, std::max(h.radius, h.depth) + h.skirt, h.chord_error);
  }
  if (part == "die") return die(h);
  return holder(h.plan, [&](double u) { return h.flange_edge(u); },
                {.underside_z = h.sheet / 2.0,
                 .thickness = v["holder-thickness"],
                 .clearance = v["holder-clearance"],
                 .fillet = v["holder-fillet"],
                 .curvature = {0.0, 1.0 / (h.opening + h.fillet)},
                 .chord_error = h.chord_error});
}

} // namespace towform::shapes
