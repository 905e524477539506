#include "contact/facet_neighbours.hpp"
#include "contact/shapes.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace towform {
namespace {

/// A tray: flat squares in one plane, a sharp inner corner, and a rough floor, so that facets are convex, concave
/// and level to each other; open at its rim.
SurfaceMesh tray()
{
  SurfaceMesh mesh;
  constexpr int n = 24;
  constexpr double pitch = 2.5e-3;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool floor = i > n / 3 && j > n / 4;
      const double rough = floor ? 4e-4 * std::sin(1.7 * i) * std::cos(2.3 * j) - 4e-3 : 0.0;
      mesh.points.push_back({pitch * i, pitch * j, rough});
    }
  test::add_squares(mesh, n);
  return mesh;
}

/// Two level plates that face each other across 3 mm.
SurfaceMesh gap()
{
  SurfaceMesh mesh;
  constexpr int n = 8;
  constexpr double pitch = 5e-3;
  for (const double z : {0.0, 3e-3})
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) mesh.points.push_back({pitch * i, pitch * j, z});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1, up = (n + 1) * (n + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
      mesh.triangles.push_back({up + a, up + c, up + b});
      mesh.triangles.push_back({up + a, up + d, up + c});
    }
  return mesh;
}

/// A level floor under curtains that end above it: planes of facets are nearer than these are.
SurfaceMesh curtains()
{
  SurfaceMesh mesh;
  constexpr int n = 8;
  constexpr double pitch = 4e-3;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.points.push_back({pitch * i, pitch * j, 0.0});
  test::add_squares(mesh, n);
  for (int i = 0; i < n; ++i) {
    const int a = static_cast<int>(mesh.points.size());
    const double x = pitch * (i + 0.5);
    for (const double z : {1e-3, 4e-3})
      for (const double y : {0.0, pitch * n}) mesh.points.push_back({x, y, z});
    mesh.triangles.push_back({a, a + 1, a + 3});
    mesh.triangles.push_back({a, a + 3, a + 2});
  }
  return mesh;
}

class Wander {
public:
  explicit Wander(unsigned seed) : generator_(seed) {}
  Vec3 direction()
  {
    const Vec3 v{by_(generator_), by_(generator_), by_(generator_)};
    return normalized(v);
  }
  double fraction() { return 0.5 + 0.5 * by_(generator_); }
  double side() { return fraction() < 0.5 ? -1.0 : 1.0; }
  int facet(const ToolSurface& surface)
  {
    return static_cast<int>(fraction() * 0.999 * static_cast<double>(surface.mesh().triangles.size()));
  }
  Vec3 on(const Facet& f)
  {
    const double a = fraction(), b = fraction() * (1.0 - a);
    return f.corner[0] + a * (f.corner[1] - f.corner[0]) + b * (f.corner[2] - f.corner[0]);
  }

private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> by_{-1.0, 1.0};
};

TEST(FacetNeighbours, FindWhatAFullSearchFindsFromAnyFacetNearby)
{
  for (const bool flat : {true, false}) {
    const ToolSurface surface(flat ? tray() : test::sphere(0.03, 24));
    const FacetNeighbours neighbours(surface, 2e-3);
    Wander wander(5);
    int far = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 on = wander.on(surface.tree().facet(wander.facet(surface)));
      const Vec3 p = on + 2.4e-3 * wander.fraction() * wander.direction();
      const SurfacePoint full = surface.nearest(p);
      const int start = surface.nearest(p + 3e-3 * wander.direction()).facet;
      const auto nearby = neighbours.nearest(p, start);
      far += std::abs(full.distance) > 1e-3;
      ASSERT_EQ(nearby.point.distance, full.distance) << i;
      ASSERT_EQ(nearby.point.normal, full.normal) << i;
      ASSERT_EQ(nearby.point.on_border, full.on_border) << i;
    }
    EXPECT_GT(far, 500); // beyond the lists
  }
}

TEST(FacetNeighbours, ThePlaneHoldsAsFarAsItsReach)
{
  for (const SurfaceMesh& mesh : {tray(), test::sphere(0.03, 24), gap(), curtains()}) {
    const ToolSurface surface(mesh);
    const FacetNeighbours neighbours(surface, 2e-3);
    Wander wander(11);
    int planes = 0, aside = 0;
    for (int i = 0; i < 4000; ++i) {
      const int facet = wander.facet(surface);
      const Facet& start = surface.tree().facet(facet);
      const Vec3 p = wander.on(start) + wander.side() * (0.1e-3 + 1.2e-3 * wander.fraction()) * start.normal;
      const auto nearest = neighbours.nearest(p, facet);
      if (nearest.reach == 0.0) continue;
      ++planes;
      ASSERT_LT(norm(p - nearest.anchor), nearest.reach);
      aside += nearest.anchor != p;
      const Facet& f = surface.tree().facet(nearest.point.facet);
      for (int k = 0; k < 8; ++k) {
        const Vec3 q = nearest.anchor + (0.999 * nearest.reach) * wander.direction();
        if (f.height(q) <= 0.0) continue; // behind the plane it promises nothing
        const SurfacePoint full = surface.nearest(q);
        ASSERT_EQ(full.distance, f.height(q)) << i << ", reach " << nearest.reach;
        ASSERT_EQ(full.normal, f.normal) << i;
      }
    }
    EXPECT_GT(planes, 1500);
    EXPECT_GT(aside, 100); // of who is near an edge
  }
}

TEST(FacetNeighbours, BothFacetsOfAnEdgeServeAsFarAsTheirReach)
{
  for (const bool flat : {true, false}) {
    const ToolSurface surface(flat ? tray() : test::sphere(0.03, 24));
    const FacetNeighbours neighbours(surface, 3e-3);
    Wander wander(17);
    int pairs = 0;
    for (int i = 0; i < 4000; ++i) {
      const int facet = wander.facet(surface);
      const Facet& f = surface.tree().facet(facet);
      const double along = wander.fraction(), height = wander.side() * 1e-3 * wander.fraction();
      const Vec3 p = f.corner[0] + along * f.edge(0) + height * f.normal;
      const FacetNeighbours::Nearest nearest = neighbours.nearest(p, facet);
      if (nearest.rival < 0) continue;
      ++pairs;
      for (int k = 0; k < 8; ++k) {
        const Vec3 q = p + (0.999 * nearest.clear) * wander.direction();
        const SurfacePoint full = surface.nearest(q), of_two = surface.nearest_of(q, nearest.point.facet, nearest.rival);
        ASSERT_EQ(full.distance, of_two.distance) << i << ", reach " << nearest.clear;
        ASSERT_EQ(full.normal, of_two.normal) << i;
      }
    }
    EXPECT_GT(pairs, 1000);
  }
}

TEST(FacetNeighbours, WhatIsFarIsNoNearerThanSaid)
{
  const ToolSurface surface(test::sphere(0.03, 24));
  const FacetNeighbours neighbours(surface, 2e-3);
  Wander wander(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = (0.031 + 0.1 * wander.fraction()) * wander.direction();
    const int start = surface.nearest(p + 5e-3 * wander.direction()).facet;
    const auto far = neighbours.far(p, start, 0.0);
    const double distance = surface.nearest(p).distance;
    if (!far) {
      EXPECT_LT(0.7 * distance, 2e-3);
      continue;
    }
    EXPECT_LE(far->distance, distance);
    EXPECT_GE(far->distance, 0.69 * distance);
    EXPECT_FALSE(neighbours.far(p, start, 1e-3)); // it may have come through the tool
  }
}

} // namespace
} // namespace towform
