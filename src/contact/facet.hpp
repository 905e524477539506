#pragma once
#include "towform/vec3.hpp"
#include <algorithm>
#include <array>

namespace towform {

/// Part of a facet that a point is nearest to: its inside, edge k (from corner k to k+1) or corner k.
enum class Feature { inside, edge_0, edge_1, edge_2, corner_0, corner_1, corner_2 };

/// The nearest point of a facet.
struct FacetPoint {
  Vec3 point;
  Feature feature = Feature::inside;
  double distance_squared = 0.0; ///< [m^2]
};

/// Nearest point of the triangle abc to p, exact for any shape of positive area: the plane's point when it
/// lies inside, else the nearest of the three edges.
inline FacetPoint nearest_on_facet(const std::array<Vec3, 3>& corner, const Vec3& p)
{
  const Vec3 e0 = corner[1] - corner[0], e1 = corner[2] - corner[1], e2 = corner[0] - corner[2];
  const Vec3 r0 = p - corner[0], r1 = p - corner[1], r2 = p - corner[2];
  const Vec3 normal = cross(e0, e1);
  // Barycentric coordinates times |normal|^2: on which side of each edge the foot of p lies.
  const double side_0 = dot(normal, cross(e0, r0));
  const double side_1 = dot(normal, cross(e1, r1));
  const double side_2 = dot(normal, cross(e2, r2));
  if (side_0 >= 0.0 && side_1 >= 0.0 && side_2 >= 0.0) {
    const double height = dot(normal, r0) / norm_squared(normal); // times |normal|
    return {p - height * normal, Feature::inside, height * height * norm_squared(normal)};
  }
  FacetPoint best;
  best.distance_squared = 1e300;
  const auto edge = [&](const Vec3& from, const Vec3& e, const Vec3& r, Feature on, Feature start,
                        Feature end) {
    const double t = std::clamp(dot(r, e) / norm_squared(e), 0.0, 1.0);
    const Vec3 point = from + t * e;
    const double d2 = norm_squared(p - point);
    if (d2 < best.distance_squared) best = {point, t <= 0.0 ? start : t >= 1.0 ? end : on, d2};
  };
  if (side_0 < 0.0) edge(corner[0], e0, r0, Feature::edge_0, Feature::corner_0, Feature::corner_1);
  if (side_1 < 0.0) edge(corner[1], e1, r1, Feature::edge_1, Feature::corner_1, Feature::corner_2);
  if (side_2 < 0.0) edge(corner[2], e2, r2, Feature::edge_2, Feature::corner_2, Feature::corner_0);
  return best;
}

} // namespace towform
