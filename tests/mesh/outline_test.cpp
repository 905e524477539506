#include "mesh/outline.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

/// Unit squares of a 4 x 4 board, each two triangles; only those marked.
SurfaceMesh board(const std::vector<std::pair<int, int>>& squares)
{
  SurfaceMesh mesh;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) mesh.points.push_back({double(i), double(j), 0.0});
  for (const auto& [i, j] : squares) {
    const int a = 5 * j + i;
    mesh.triangles.push_back({a, a + 1, a + 6});
    mesh.triangles.push_back({a, a + 6, a + 5});
  }
  return mesh;
}

TEST(Outline, RunsWithTheSheetOnItsLeft)
{
  const SurfaceMesh mesh = board({{0, 0}, {1, 0}});
  const auto edges = outline_edges(mesh.triangles);
  ASSERT_EQ(edges.size(), 6U);
  double twice_area = 0.0;
  for (const auto& [a, b] : edges) {
    const Vec3 &p = mesh.points[a], &q = mesh.points[b];
    twice_area += p.x * q.y - q.x * p.y;
  }
  EXPECT_EQ(twice_area, 4.0);
}

TEST(Outline, IsMetLastByARay)
{
  // A ring: the ray crosses the hole's edge twice and the outline once.
  std::vector<std::pair<int, int>> ring;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      if (i == 0 || i == 3 || j == 0 || j == 3) ring.emplace_back(i, j);
  const SurfaceMesh mesh = board(ring);
  const auto edges = outline_edges(mesh.triangles);
  const auto met = [&](Vec2 from, Vec2 to) {
    return last_crossing(edges, mesh.points, from, to).at(mesh.points);
  };
  EXPECT_EQ(met({2, 2}, {4, 2}), (Vec3{4, 2, 0}));     // a node on the ray
  EXPECT_EQ(met({2, 2}, {4, 4}), (Vec3{4, 4, 0}));     // a corner
  EXPECT_EQ(met({2, 2}, {0, 2.5}), (Vec3{0, 2.5, 0})); // between nodes
  EXPECT_EQ(met({2, 2}, {2, 2.1}), (Vec3{2, 4, 0}));   // `to` gives the direction only
}

TEST(Outline, ARayThatMissesItTakesTheNearestNode)
{
  // An L without its upper right: nothing lies on the ray from the middle to that corner of its box.
  const SurfaceMesh mesh = board({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {0, 2}, {0, 3}});
  const auto edges = outline_edges(mesh.triangles);
  const Vec3 at = last_crossing(edges, mesh.points, {2, 2}, {4, 3}).at(mesh.points);
  EXPECT_EQ(at, (Vec3{4, 1, 0}));
}

} // namespace
} // namespace towform
