#include "mesh/tool_shapes/parts.hpp"
#include "mesh/tool_shapes/values.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace towform::shapes {

namespace {

/// A hill round a line: heights depend on the distance d from the line alone, level up to `crown`, then half
/// a wave of cosine down over `flank`.
struct MaleDome {
  Plan plan;
  double crown, flank, height, gap, base, sheet, chord_error;

  /// A face `offset` away from the hill, lifted or lowered so that its crown or its foot is at a height.
  struct Face {
    double offset;
    double crown_z, foot_z; ///< exact where the face is said to be, within rounding of it at the other end
    bool from_crown;
  };
  [[nodiscard]] Face from_crown(double offset, double z) const { return {offset, z, z - height, true}; }
  [[nodiscard]] Face from_foot(double offset, double z) const { return {offset, z + height, z, false}; }

  /// A face's ring at t = 0 (crown's end) to 1 (foot).
  [[nodiscard]] Curve level(double t, const Face& face) const
  {
    const double wave = std::cos(std::numbers::pi * t);
    const double slope = 0.5 * height * std::numbers::pi / flank * std::sin(std::numbers::pi * t);
    const double up = 1.0 / std::hypot(1.0, slope), out = slope * up;
    const double d = crown + flank * t + face.offset * out;
    const double z = (face.from_crown ? face.crown_z - 0.5 * height * (1.0 - wave)
                                      : face.foot_z + 0.5 * height * (1.0 + wave)) +
                     face.offset * (up - 1.0);
    return [centre = plan.centre, d, z](double u) -> Vec3 {
      if (u < 1.0) return {centre * u, d, z};
      const double angle = (2.0 - u) * std::numbers::pi / 2.0;
      return {centre + d * std::cos(angle), d * std::sin(angle), z};
    };
  }
  /// Least radius of the profile, at the crown's end (convex) and the foot (concave).
  [[nodiscard]] double sharpest() const
  {
    return 2.0 * flank * flank / (height * std::numbers::pi * std::numbers::pi);
  }
  /// Rings of a face, from the line outwards to the rim.
  [[nodiscard]] std::vector<Ring> rings(Quarter& quarter, const Face& face) const;
};

std::vector<Ring> MaleDome::rings(Quarter& quarter, const Face& face) const
{
  const double budget = chord_share * chord_error;
  const Facets facets = edge_facets(plan, sharpest(), {0.0, 1.0 / (crown + face.offset)}, budget);
  // Even in plan: the profile turns least where it is steep.
  const int flank_rings = std::max(4, static_cast<int>(std::ceil(flank / facets.across)));
  std::vector<Ring> rings;
  const auto add = [&rings](const std::vector<Ring>& more) {
    rings.insert(rings.end(), more.begin(), more.end());
  };
  const Along<int> inner = intervals(level(0.0, face), facets.along);
  rings.push_back(plan.spine(quarter, face.crown_z, inner.middle));
  add(plan.between(quarter, plan.spine(face.crown_z), level(0.0, face), facets.along.middle,
                   facets.along.middle, false));
  for (int i = 0; i <= flank_rings; ++i) {
    const Curve ring = level(static_cast<double>(i) / flank_rings, face);
    rings.push_back(quarter.ring(ring, {inner.middle, intervals(ring, facets.along).dome}));
  }
  add(plan.between(quarter, level(1.0, face), plan.rectangle(face.foot_z), facets.along.dome, flat_spacing,
                   true));
  rings.push_back(plan.rim(quarter, face.foot_z, flat_spacing));
  return rings;
}

/// A face closed by walls and a flat back at `back_z`.
SurfaceMesh closed(const MaleDome& d, const MaleDome::Face& face, double back_z)
{
  Quarter quarter;
  std::vector<Ring> rings = d.rings(quarter, face);
  rings.push_back(d.plan.rim(quarter, back_z, flat_spacing));
  for (const Ring& ring : d.plan.between(quarter, d.plan.rectangle(back_z), d.plan.spine(back_z),
                                         flat_spacing, flat_spacing, true))
    rings.push_back(ring);
  rings.push_back(d.plan.spine(quarter, back_z, flat_spacing));
  if (back_z > face.foot_z) std::reverse(rings.begin(), rings.end()); // the face looks down
  quarter.loft(rings);
  return quarter.mirrored();
}

void check(const MaleDome& d)
{
  if (d.gap < d.sheet)
    throw std::invalid_argument(
        fmt::format("gap = {} is less than sheet-thickness = {}", millimetres(d.gap), millimetres(d.sheet)));
  if (d.gap >= 0.95 * d.sharpest())
    throw std::invalid_argument(fmt::format(
        "gap = {} does not fit round the hill's foot, whose radius is {} (height = {}, flank = {})",
        millimetres(d.gap), millimetres(d.sharpest()), millimetres(d.height), millimetres(d.flank)));
  check_flat_face(d.plan, d.level(1.0, d.from_foot(0.0, 0.0)), "the hill's foot");
}

} // namespace

SurfaceMesh build_male_dome(const std::string& part, const Values& v)
{
  MaleDome d{};
  d.plan = {v["flange-length"] / 2.0, v["flange-width"] / 2.0, v["line-length"] / 2.0};
  d.crown = v["crown"];
  d.flank = v["flank"];
  d.height = v["height"];
  d.gap = v["gap"];
  d.base = v["base"];
  d.sheet = v["sheet-thickness"];
  d.chord_error = v["chord-error"];
  check(d);
  if (part == "mould") {
    const double crown = -d.sheet / 2.0;
    return closed(d, d.from_crown(0.0, crown), crown - d.height - d.base);
  }
  // The press starts with its flange on the sheet's upper face and comes down by height + sheet - gap.
  const double flange = d.sheet / 2.0;
  return closed(d, d.from_foot(d.gap, flange), flange + d.height + d.base);
}

} // namespace towform::shapes
