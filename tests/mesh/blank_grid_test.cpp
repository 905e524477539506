#include "flat_mesh_checks.hpp"
#include "mesh/blank_grid.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {
constexpr Vec2 sheet{0.65, 0.45};
constexpr Pattern grids[] = {Pattern::cross, Pattern::diagonal};
} // namespace

TEST(BlankGrid, ChoosesCountsNearTheWantedNumberWithSquareCells)
{
  for (const Pattern pattern : grids) {
    for (const int elements : {5000, 10000, 21706, 65432, 300000, 1000000}) {
      const GridCounts c = grid_for_elements(sheet, elements, pattern);
      EXPECT_EQ(c.x % 2, 0);
      EXPECT_EQ(c.y % 2, 0);
      EXPECT_NEAR(triangles_per_cell(pattern) * c.x * c.y, elements, 0.01 * elements);
      EXPECT_NEAR((sheet.x / c.x) / (sheet.y / c.y), 1.0, elements < 20000 ? 0.1 : 0.03) << elements;
    }
  }
}

TEST(BlankGrid, ChoosesSensibleCountsForFewElementsAndLongSheets)
{
  const GridCounts least = grid_for_elements(sheet, 2, Pattern::diagonal);
  EXPECT_EQ(least.x, 2);
  EXPECT_EQ(least.y, 2);
  const GridCounts wide = grid_for_elements({10.0, 0.01}, 4000, Pattern::diagonal);
  EXPECT_EQ(wide.y, 2);
  EXPECT_EQ(wide.x, 1000);
  const GridCounts tall = grid_for_elements({0.01, 10.0}, 4000, Pattern::diagonal);
  EXPECT_EQ(tall.x, 2);
  EXPECT_EQ(tall.y, 1000);
}

TEST(BlankGrid, ChoosesTheEvenCountsNearestToAnEdge)
{
  const GridCounts c = grid_for_edge({0.65, 0.45}, 0.005);
  EXPECT_EQ(c.x, 130);
  EXPECT_EQ(c.y, 90);
  const GridCounts d = grid_for_edge({0.65, 0.45}, 1.0);
  EXPECT_EQ(d.x, 2);
  EXPECT_EQ(d.y, 2);
  EXPECT_EQ(grid_for_edge({0.65, 0.45}, 0.65 / 8.9).x, 8);
  EXPECT_EQ(grid_for_edge({0.65, 0.45}, 0.65 / 9.1).x, 10);
}

TEST(BlankGrid, FillsTheWholeSheetAndItsParts)
{
  for (const Pattern pattern : grids) {
    for (const Symmetry symmetry : {Symmetry::none, Symmetry::x, Symmetry::y, Symmetry::quarter}) {
      const bool half_x = symmetry == Symmetry::x || symmetry == Symmetry::quarter;
      const bool half_y = symmetry == Symmetry::y || symmetry == Symmetry::quarter;
      const SurfaceMesh mesh = aligned_grid(sheet, {14, 10}, pattern, symmetry);
      expect_fills_rectangle(mesh, {half_x ? 0.0 : -0.325, half_y ? 0.0 : -0.225}, {0.325, 0.225});
      const std::size_t whole = triangles_per_cell(pattern) * 14 * 10;
      EXPECT_EQ(mesh.triangles.size(), whole / (half_x ? 2 : 1) / (half_y ? 2 : 1));
    }
  }
}

TEST(BlankGrid, IsItsOwnMirrorImageToTheBit)
{
  for (const Pattern pattern : grids) {
    const SurfaceMesh mesh = aligned_grid({0.653, 0.4507}, {18, 14}, pattern, Symmetry::none);
    const auto all = placed_triangles(mesh);
    EXPECT_EQ(all.size(), mesh.triangles.size());
    EXPECT_EQ(placed_triangles(mesh, -1.0, 1.0), all);
    EXPECT_EQ(placed_triangles(mesh, 1.0, -1.0), all);
  }
}

TEST(BlankGrid, PartsAreTheWholesTriangles)
{
  for (const Pattern pattern : grids) {
    const auto whole = placed_triangles(aligned_grid({0.653, 0.4507}, {18, 14}, pattern, Symmetry::none));
    for (const Symmetry symmetry : {Symmetry::x, Symmetry::y, Symmetry::quarter}) {
      const auto part = placed_triangles(aligned_grid({0.653, 0.4507}, {18, 14}, pattern, symmetry));
      EXPECT_TRUE(std::includes(whole.begin(), whole.end(), part.begin(), part.end()));
    }
  }
}

TEST(BlankGrid, DiagonalsRunOutwards)
{
  const SurfaceMesh mesh = aligned_grid({6, 4}, {6, 4}, Pattern::diagonal, Symmetry::none);
  int diagonals = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.points[t[k]], &b = mesh.points[t[(k + 1) % 3]];
      if (a.x == b.x || a.y == b.y) continue;
      ++diagonals;
      EXPECT_GT((b.x - a.x) * (b.y - a.y) * (a.x + b.x) * (a.y + b.y), 0.0);
    }
  }
  EXPECT_EQ(diagonals, 48);
}

} // namespace towform
