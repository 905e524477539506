#pragma once
#include "towform/surface_mesh.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace towform {

inline double signed_area(const SurfaceMesh& mesh, const Triangle& t)
{
  return 0.5 * cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]).z;
}

/// Smallest angle of all triangles [rad].
inline double smallest_angle(const SurfaceMesh& mesh)
{
  double least = 4.0;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const Vec3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      least = std::min(least, std::atan2(norm(cross(a, b)), dot(a, b)));
    }
  }
  return least;
}

/// Lies flat and counter-clockwise, uses every node, fills the rectangle exactly (areas sum up to rounding),
/// and its boundary is one closed loop along the sides.
inline void expect_fills_rectangle(const SurfaceMesh& mesh, Vec2 low, Vec2 high)
{
  double area = 0.0, least = 1e300;
  std::vector<bool> used(mesh.points.size());
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles) {
    area += signed_area(mesh, t);
    least = std::min(least, signed_area(mesh, t));
    for (int k = 0; k < 3; ++k) {
      used[t[k]] = true;
      EXPECT_TRUE(edges.insert({t[k], t[(k + 1) % 3]}).second) << "an edge used twice in one direction";
    }
  }
  EXPECT_GT(least, 0.0);
  const double whole = (high.x - low.x) * (high.y - low.y);
  EXPECT_NEAR(area, whole, 1e-12 * whole);
  EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
  for (const Vec3& p : mesh.points) {
    EXPECT_TRUE(p.z == 0.0 && p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y);
    EXPECT_FALSE(std::signbit(p.x) && p.x == 0.0) << "negative zero";
    EXPECT_FALSE(std::signbit(p.y) && p.y == 0.0) << "negative zero";
  }

  std::map<int, int> next; // along the boundary
  for (const auto& [a, b] : edges) {
    if (edges.count({b, a}) != 0) continue;
    EXPECT_TRUE(next.insert({a, b}).second) << "the boundary touches itself";
    const Vec3 &p = mesh.points[a], &q = mesh.points[b];
    const bool on_side =
        (p.y == low.y && q.y == low.y && q.x > p.x) || (p.x == high.x && q.x == high.x && q.y > p.y) ||
        (p.y == high.y && q.y == high.y && q.x < p.x) || (p.x == low.x && q.x == low.x && q.y < p.y);
    EXPECT_TRUE(on_side);
  }
  ASSERT_FALSE(next.empty());
  std::size_t length = 0;
  int at = next.begin()->first;
  do {
    ASSERT_EQ(next.count(at), 1u);
    at = next[at];
    ++length;
  } while (at != next.begin()->first && length <= next.size());
  EXPECT_EQ(length, next.size()) << "more than one loop";
}

using PlacedTriangle = std::array<std::pair<double, double>, 3>;

/// The triangles as sorted places of their corners, coordinates multiplied by sign_x and sign_y.
inline std::set<PlacedTriangle> placed_triangles(const SurfaceMesh& mesh, double sign_x = 1.0,
                                                 double sign_y = 1.0)
{
  std::set<PlacedTriangle> all;
  for (const Triangle& t : mesh.triangles) {
    PlacedTriangle p;
    for (int k = 0; k < 3; ++k)
      p[k] = {sign_x * mesh.points[t[k]].x + 0.0, sign_y * mesh.points[t[k]].y + 0.0};
    std::sort(p.begin(), p.end());
    all.insert(p);
  }
  return all;
}

} // namespace towform
