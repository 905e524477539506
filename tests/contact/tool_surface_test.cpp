#include "contact/shapes.hpp"
#include "contact/tool_surface.hpp"
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>
#include <random>

namespace towform {
namespace {

std::vector<Vec3> random_points(double extent, int count)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> in(-extent, extent);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back({in(generator), in(generator), in(generator)});
  return points;
}

TEST(Facet, NearestPointIsNoFartherThanAnyOther)
{
  const std::array<Vec3, 3> corner{Vec3{0, 0, 0}, {1, 0.1, 0}, {0.2, 0.02, 0.3}}; // a sliver
  const Facet facet(corner);
  for (const Vec3& p : random_points(2.0, 500)) {
    const FacetPoint nearest = nearest_on_facet(facet, p);
    EXPECT_NEAR(nearest.distance_squared, norm_squared(p - nearest.point), 1e-12);
    double best = 1e300;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j + i <= 60; ++j) {
        const Vec3 q =
            corner[0] + (i / 60.0) * (corner[1] - corner[0]) + (j / 60.0) * (corner[2] - corner[0]);
        best = std::min(best, norm_squared(p - q));
      }
    EXPECT_LE(nearest.distance_squared, best + 1e-12);
    EXPECT_GE(std::sqrt(nearest.distance_squared), std::sqrt(best) - 0.02); // the samples are that far apart
  }
}

TEST(FacetTree, AgreesWithBruteForce)
{
  const SurfaceMesh mesh = test::sphere(1.0, 12);
  const FacetTree tree(mesh);
  for (const Vec3& p : random_points(1.5, 400)) {
    std::vector<std::pair<double, int>> all;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      all.emplace_back(nearest_on_facet(tree.facet(t), p).distance_squared, t);
    std::sort(all.begin(), all.end());
    EXPECT_EQ(tree.nearest(p, 1e100), all.front().second);
    EXPECT_EQ(tree.nearest(p, 0.5 * std::sqrt(all.front().first)), -1);
  }
}

TEST(ToolSurface, SignedDistanceOfACube)
{
  const ToolSurface cube(test::box({-1, -1, -1}, {1, 1, 1}));
  for (const Vec3& p : random_points(2.0, 2000)) {
    const Vec3 q{std::abs(p.x) - 1.0, std::abs(p.y) - 1.0, std::abs(p.z) - 1.0};
    const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    const double exact = norm(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
    const SurfacePoint nearest = cube.nearest(p);
    EXPECT_NEAR(nearest.distance, exact, 1e-12);
    EXPECT_NEAR(norm(nearest.normal), 1.0, 1e-12);
    // Along the normal the distance grows by what one moves.
    EXPECT_NEAR(cube.nearest(p + 1e-4 * nearest.normal).distance, exact + 1e-4, 1e-9);
    EXPECT_FALSE(nearest.on_border);
  }
}

TEST(ToolSurface, HintsDoNotChangeTheAnswer)
{
  const ToolSurface sphere(test::sphere(1.0, 12));
  for (const Vec3& p : random_points(1.5, 300)) {
    const SurfacePoint nearest = sphere.nearest(p), hinted = sphere.nearest(p, 17);
    EXPECT_EQ(nearest.facet, hinted.facet);
    EXPECT_EQ(nearest.point, hinted.point);
  }
}

TEST(ToolSurface, AnOpenSheetHasABorder)
{
  SurfaceMesh plate;
  plate.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  plate.triangles = {{0, 1, 2}, {0, 2, 3}};
  const ToolSurface tool(plate);
  EXPECT_FALSE(tool.nearest({0.5, 0.4, -0.1}).on_border);
  EXPECT_NEAR(tool.nearest({0.5, 0.4, -0.1}).distance, -0.1, 1e-15);
  EXPECT_TRUE(tool.nearest({1.2, 0.4, 0.0}).on_border);
  EXPECT_TRUE(tool.nearest({1.2, 1.2, -0.1}).on_border);
}

TEST(ToolSurface, AgreesWithFclOutsideTheBody)
{
  const SurfaceMesh mesh = test::sphere(1.0, 8);
  const ToolSurface tool(mesh);
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Vector3d> points;
  std::vector<fcl::Triangle> triangles;
  for (const Vec3& p : mesh.points) points.emplace_back(p.x, p.y, p.z);
  for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel();
  model->addSubModel(points, triangles);
  model->endModel();
  const fcl::CollisionObjectd body(model);
  constexpr double radius = 1e-4;
  const auto ball = std::make_shared<fcl::Sphered>(radius);
  for (const Vec3& p : random_points(2.0, 60)) {
    const double distance = tool.nearest(p).distance;
    if (distance < 0.01) continue; // FCL's answers are wrong where bodies overlap
    const fcl::CollisionObjectd point(ball, fcl::Transform3d(fcl::Translation3d(p.x, p.y, p.z)));
    fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    fcl::distance(&body, &point, request, result);
    EXPECT_NEAR(result.min_distance, distance - radius, 1e-5);
  }
}

} // namespace
} // namespace towform
