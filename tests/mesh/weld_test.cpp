#include "towform/surface_mesh.hpp"
#include <gtest/gtest.h>
#include <random>

namespace towform {

TEST(Weld, JoinsPointsWithinTheToleranceOnly)
{
  const SurfaceMesh mesh{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.0 + 0.9e-3, 0, 0}, {1, 1, 0}, {0, 1.0 + 1.1e-3, 0}},
      {{0, 1, 2}, {3, 4, 5}}};
  const SurfaceMesh welded = weld(mesh, 1e-3, false);
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1.0 + 1.1e-3, 0}};
  EXPECT_EQ(welded.points, points);
  EXPECT_EQ(welded.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 4}}));
}

TEST(Weld, ZeroToleranceJoinsEqualPoints)
{
  const SurfaceMesh mesh{{{0, 0, 0}, {-0.0, 0, -0.0}, {1e-300, 0, 0}, {0, 0, 0}}, {}};
  EXPECT_EQ(weld(mesh, 0.0, false).points.size(), 2u);
}

TEST(Weld, DropsCollapsedFacetsOnlyWhenAsked)
{
  const SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_EQ(weld(mesh, 1e-6, false).triangles, (std::vector<Triangle>{{0, 1, 1}, {0, 1, 2}}));
  EXPECT_EQ(weld(mesh, 1e-6, true).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Weld, AgreesWithComparingAllPairs)
{
  const double tolerance = 0.02;
  std::mt19937 random(7);
  SurfaceMesh mesh;
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  for (int k = 0; k < 3000; ++k) {
    const double x = next(), y = next(), z = next();
    mesh.points.push_back({x, y, 0.2 * z});
    mesh.triangles.push_back({k, k, k});
  }
  std::vector<Vec3> kept;
  std::vector<int> joined;
  for (const Vec3& p : mesh.points) {
    int nearest = -1;
    for (int k = 0; k < static_cast<int>(kept.size()); ++k) {
      if (norm(kept[k] - p) <= tolerance && (nearest < 0 || norm(kept[k] - p) < norm(kept[nearest] - p))) {
        nearest = k;
      }
    }
    if (nearest < 0) {
      nearest = static_cast<int>(kept.size());
      kept.push_back(p);
    }
    joined.push_back(nearest);
  }
  const SurfaceMesh welded = weld(mesh, tolerance, false);
  EXPECT_EQ(welded.points, kept);
  EXPECT_LT(kept.size(), mesh.points.size() - 100);
  for (std::size_t k = 0; k < joined.size(); ++k) EXPECT_EQ(welded.triangles[k][0], joined[k]);
}

} // namespace towform
