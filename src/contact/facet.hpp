#pragma once
#include "towform/vec3.hpp"
#include <algorithm>
#include <array>

namespace towform {

/// Part of a facet that a point is nearest to: its inside, edge k (from corner k to k+1) or corner k.
enum class Feature { inside, edge_0, edge_1, edge_2, corner_0, corner_1, corner_2 };

/// Which edge it is, or -1.
inline int edge_number(Feature feature)
{
  const int k = static_cast<int>(feature) - static_cast<int>(Feature::edge_0);
  return k < 3 ? k : -1;
}

/// The nearest point of a facet.
struct FacetPoint {
  Vec3 point;
  Feature feature = Feature::inside;
  double distance_squared = 0.0; ///< [m^2]
};

/// A triangle of a tool with what its nearest points are found by.
struct alignas(64) Facet {
  std::array<Vec3, 3> corner;
  Vec3 normal;                ///< unit, outward
  double offset;              ///< normal . x of its plane [m]
  std::array<Vec3, 3> inward; ///< unit, in the plane, from edge k (corner k to k+1) to the inside
  // What lies beyond its edges, here as it is looked at together:
  std::array<int, 3> across{-1, -1, -1}; ///< the facet there, or -1 where the surface ends
  std::array<bool, 3> goes_on{};         ///< it lies in the same plane, to the last bit: the edge is none to who is near it

  explicit Facet(const std::array<Vec3, 3>& corners)
      : corner(corners), normal(normalized(cross(corner[1] - corner[0], corner[2] - corner[0]))),
        offset(dot(normal, corner[0]))
  {
    for (std::size_t k = 0; k < 3; ++k) inward[k] = normalized(cross(normal, edge(k)));
  }
  [[nodiscard]] Vec3 edge(std::size_t k) const { return corner[(k + 1) % 3] - corner[k]; }
  /// Signed distance of a point from the plane [m].
  [[nodiscard]] double height(const Vec3& p) const { return dot(normal, p) - offset; }
};

/// Nearest point of a facet to p, exact for any shape of positive area: the plane's point when it lies
/// inside, else the nearest of the three edges.
inline FacetPoint nearest_on_facet(const Facet& f, const Vec3& p)
{
  const std::array<Vec3, 3> r{p - f.corner[0], p - f.corner[1], p - f.corner[2]};
  const std::array<bool, 3> outside{dot(f.inward[0], r[0]) < 0.0, dot(f.inward[1], r[1]) < 0.0,
                                    dot(f.inward[2], r[2]) < 0.0};
  if (!(outside[0] || outside[1] || outside[2])) {
    const double height = f.height(p);
    return {p - height * f.normal, Feature::inside, height * height};
  }
  FacetPoint best;
  best.distance_squared = 1e300;
  constexpr std::array<std::array<Feature, 3>, 3> features{
      {{Feature::edge_0, Feature::corner_0, Feature::corner_1},
       {Feature::edge_1, Feature::corner_1, Feature::corner_2},
       {Feature::edge_2, Feature::corner_2, Feature::corner_0}}}; // of an edge, its start and its end
  for (std::size_t k = 0; k < 3; ++k) {
    if (!outside[k]) continue;
    const Vec3 e = f.edge(k);
    const double t = std::clamp(dot(r[k], e) / norm_squared(e), 0.0, 1.0);
    const Vec3 point = f.corner[k] + t * e;
    const double d2 = norm_squared(p - point);
    if (d2 < best.distance_squared) best = {point, features[k][t <= 0.0 ? 1 : t >= 1.0 ? 2 : 0], d2};
  }
  return best;
}

} // namespace towform
