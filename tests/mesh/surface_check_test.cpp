#include "mesh/surface_check.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

/// A strip of unit squares, two facets each, open all round.
SurfaceMesh strip()
{
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {1, 0, 1}},
          {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
}

void expect_fault(const SurfaceMesh& mesh, SurfaceDefect defect, int facet, int other, int count)
{
  const auto fault = check_surface(mesh);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->defect, defect);
  EXPECT_EQ(fault->facet, facet);
  EXPECT_EQ(fault->other, other);
  EXPECT_EQ(fault->count, count);
}

} // namespace

TEST(SurfaceCheck, AcceptsOpenSurfaces) { EXPECT_FALSE(check_surface(strip())); }

TEST(SurfaceCheck, FindsRepeatedCornersAndZeroArea)
{
  SurfaceMesh mesh = strip();
  mesh.triangles.push_back({0, 1, 2});
  mesh.triangles.push_back({5, 2, 5});
  expect_fault(mesh, SurfaceDefect::degenerate, 4, 4, 2);
}

TEST(SurfaceCheck, JudgesAreaByShapeNotSize)
{
  SurfaceMesh mesh{{{0, 0, 0}, {1e-6, 0, 0}, {0, 1e-6, 0}}, {{0, 1, 2}}};
  EXPECT_FALSE(check_surface(mesh));
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 2e-6, 0}};
  EXPECT_FALSE(check_surface(mesh));
  mesh.points[2].y = 0.5e-6;
  expect_fault(mesh, SurfaceDefect::degenerate, 0, 0, 1);
}

TEST(SurfaceCheck, FindsDuplicatesInAnyOrderOfCorners)
{
  SurfaceMesh mesh = strip();
  mesh.triangles.push_back({3, 0, 4}); // the same side
  mesh.triangles.push_back({5, 2, 1}); // the other side
  mesh.triangles.push_back({4, 0, 3});
  expect_fault(mesh, SurfaceDefect::duplicate, 4, 1, 3);
}

TEST(SurfaceCheck, FindsEdgesWithMoreThanTwoFacets)
{
  SurfaceMesh mesh = strip();
  mesh.triangles.push_back({1, 4, 6});
  expect_fault(mesh, SurfaceDefect::crowded, 0, 0, 1);
}

TEST(SurfaceCheck, FindsNeighboursThatFaceOppositeSides)
{
  SurfaceMesh mesh = strip();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  expect_fault(mesh, SurfaceDefect::orientation, 0, 3, 2);
}

TEST(SurfaceCheck, FindsThatABandWithATwistHasOneSide)
{
  SurfaceMesh mesh;
  const int n = 12;
  for (int k = 0; k < n; ++k) {
    const double t = 2.0 * 3.141592653589793 * k / n;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1.0 + w * std::cos(0.5 * t);
      mesh.points.push_back({r * std::cos(t), r * std::sin(t), w * std::sin(0.5 * t)});
    }
    const int a = 2 * k, b = a + 1;
    const bool last = k == n - 1; // joined the other way round
    const int c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({b, c, d});
  }
  expect_fault(mesh, SurfaceDefect::orientation, 0, 2 * n - 1, 1);
}

TEST(SurfaceCheck, DescribesFacetsCountedFromOne)
{
  EXPECT_EQ(describe({SurfaceDefect::duplicate, 4, 1, 3}),
            "facet 5 has the same corners as facet 2 (3 such facets in all); remove duplicate facets in the "
            "program "
            "that made the mesh");
  EXPECT_EQ(describe({SurfaceDefect::orientation, 0, 3, 1}),
            "facets 1 and 4 share an edge but face opposite sides (1 such edge in all); orient all normals "
            "outwards "
            "in the program that made the mesh");
}

} // namespace towform
