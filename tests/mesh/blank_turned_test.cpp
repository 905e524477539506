#include "flat_mesh_checks.hpp"
#include "mesh/blank_grid.hpp"
#include "mesh/blank_lattice.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace towform {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr Rectangle sheet{{-0.325, -0.225}, {0.325, 0.225}};
constexpr Pattern grids[] = {Pattern::cross, Pattern::diagonal};

/// A point in units of the cell's edge along the grid's lines.
Vec2 in_grid(const Vec3& p, double edge, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {(p.x * c + p.y * s) / edge, (p.y * c - p.x * s) / edge};
}

/// Is this the triangle that the pattern has at its place?
bool is_of_pattern(const SurfaceMesh& mesh, const Triangle& t, double edge, double angle, Pattern pattern)
{
  Vec2 p[3], mean;
  for (int k = 0; k < 3; ++k) {
    p[k] = in_grid(mesh.points[t[k]], edge, angle);
    mean = {mean.x + p[k].x / 3, mean.y + p[k].y / 3};
  }
  const int i = static_cast<int>(std::floor(mean.x)), j = static_cast<int>(std::floor(mean.y));
  int corners = 0, centres = 0;
  bool away = false; // from the diagonal
  for (const Vec2& q : p) {
    const double u = q.x - i, v = q.y - j;
    const bool corner =
        (std::abs(u) < 1e-9 || std::abs(u - 1) < 1e-9) && (std::abs(v) < 1e-9 || std::abs(v - 1) < 1e-9);
    corners += corner;
    centres += std::abs(u - 0.5) < 1e-9 && std::abs(v - 0.5) < 1e-9;
    if (corner) away |= (std::abs(u - v) < 0.5) != rising_diagonal(i, j);
  }
  if (pattern == Pattern::cross) return corners == 2 && centres == 1;
  int on_diagonal = 0;
  for (const Vec2& q : p) on_diagonal += (std::abs((q.x - i) - (q.y - j)) < 0.5) == rising_diagonal(i, j);
  return corners == 3 && on_diagonal == 2 && away;
}

double distance_inside(const Vec3& p, const Rectangle& r)
{
  return std::min({p.x - r.low.x, r.high.x - p.x, p.y - r.low.y, r.high.y - p.y});
}

} // namespace

/// A bias-extension specimen whose corners are points of the grid: every element is half or a quarter of a
/// cell, at the sides too.
TEST(TurnedGrid, MeetsTheSidesWhenTheyAreDiagonalsOfItsCells)
{
  for (const Pattern pattern : grids) {
    for (const int diagonals : {6, 7, 8}) {
      const double edge = 0.1 / (diagonals * std::numbers::sqrt2);
      const Rectangle part{{-0.05, -0.1}, {0.05, 0.1}};
      if (pattern == Pattern::diagonal && diagonals % 2 != 0) continue; // corners in the middle of cells
      const SurfaceMesh mesh = turned_grid(part, {edge, 45.0 * degree, pattern});
      expect_fills_rectangle(mesh, part.low, part.high);
      for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.points[t[1]] - mesh.points[t[0]], b = mesh.points[t[2]] - mesh.points[t[0]];
        const double area = 0.5 * (a.x * b.y - a.y * b.x) / (edge * edge);
        EXPECT_NEAR(area, pattern == Pattern::cross ? 0.25 : 0.5, 1e-9);
      }
    }
  }
}

TEST(TurnedGrid, FillsTheRectangleWithThePatternInside)
{
  const double edge = 0.0137;
  for (const Pattern pattern : grids) {
    for (const double angle : {1.0, 10.0, 30.0, 45.0, 60.0, 89.0, 135.0, -20.0, 200.0}) {
      const SurfaceMesh mesh = turned_grid(sheet, {edge, angle * degree, pattern});
      expect_fills_rectangle(mesh, sheet.low, sheet.high);
      EXPECT_EQ(static_cast<std::int64_t>(mesh.triangles.size()),
                count_turned_grid(sheet, {edge, angle * degree, pattern}));
      std::size_t inside = 0;
      for (const Triangle& t : mesh.triangles) {
        double least = 1.0;
        for (const int k : t) least = std::min(least, distance_inside(mesh.points[k], sheet));
        if (least < 1.7 * edge) continue; // where the sides may take part
        ++inside;
        EXPECT_TRUE(is_of_pattern(mesh, t, edge, angle * degree, pattern)) << angle;
      }
      EXPECT_GT(inside, mesh.triangles.size() / 2);
    }
  }
}

TEST(TurnedGrid, TrianglesAtTheSidesAreWellShaped)
{
  for (const Pattern pattern : grids) {
    for (int angle = 5; angle < 90; angle += 5) {
      // Measured: 24 degrees at worst.
      EXPECT_GT(smallest_angle(turned_grid(sheet, {0.0091, angle * degree, pattern})), 22.0 * degree)
          << angle;
    }
  }
}

TEST(TurnedGrid, KeepsThePatternUpToMirrorPlanesAt45Degrees)
{
  const Rectangle quarter{{0.0, 0.0}, sheet.high};
  const double edge = 0.0137;
  for (const Pattern pattern : grids) {
    for (const double angle : {45.0, -45.0, 135.0}) {
      const SurfaceMesh mesh = turned_grid(quarter, {edge, angle * degree, pattern});
      expect_fills_rectangle(mesh, quarter.low, quarter.high);
      EXPECT_EQ(static_cast<std::int64_t>(mesh.triangles.size()),
                count_turned_grid(quarter, {edge, angle * degree, pattern}));
      for (const Triangle& t : mesh.triangles) {
        double least = 1.0;
        for (const int k : t) least = std::min(least, distance_inside(mesh.points[k], sheet));
        // Half cells on the planes are triangles of the pattern too.
        if (least > 1.7 * edge) {
          EXPECT_TRUE(is_of_pattern(mesh, t, edge, angle * degree, pattern)) << angle;
        }
      }
    }
  }
}

TEST(TurnedGrid, RectanglesSmallerThanACell)
{
  for (const Pattern pattern : grids) {
    const Rectangle small{{-0.01, -0.005}, {0.01, 0.005}};
    EXPECT_EQ(turned_grid(small, {1.0, 0.3, pattern}).triangles.size(), 2u);
    expect_fills_rectangle(turned_grid({{-1.0, -0.001}, {1.0, 0.001}}, {0.01, 0.3, pattern}), {-1.0, -0.001},
                           {1.0, 0.001});
  }
}

} // namespace towform
