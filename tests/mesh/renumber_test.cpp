#include "mesh/blank_grid.hpp"
#include "mesh/renumber.hpp"
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace towform {

TEST(HilbertOrder, VisitsNeighbouringCells)
{
  const int n = 32;
  std::vector<Vec2> points;
  for (int k = 0; k < n * n; ++k) points.push_back({double(k % n), double(k / n)});
  std::shuffle(points.begin(), points.end(), std::mt19937(5));
  const std::vector<int> order = hilbert_order(points);
  ASSERT_EQ(order.size(), points.size());
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Vec2 &a = points[order[k - 1]], &b = points[order[k]];
    EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1.0);
  }
}

TEST(HilbertOrder, TakesAnyNumberOfPoints)
{
  EXPECT_TRUE(hilbert_order({}).empty());
  EXPECT_EQ(hilbert_order(std::vector<Vec2>{{3, 4}}), std::vector<int>{0});
  EXPECT_EQ(hilbert_order(std::vector<Vec2>{{3, 4}, {3, 4}}), (std::vector<int>{0, 1}));
}

TEST(Renumber, GivesTheSameMeshWhateverTheNumbersBefore)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {26, 18}, Pattern::cross, Symmetry::none);
  SurfaceMesh shuffled = mesh;
  std::vector<int> number(mesh.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(6);
  std::shuffle(number.begin(), number.end(), random);
  for (std::size_t k = 0; k < number.size(); ++k) shuffled.points[number[k]] = mesh.points[k];
  for (Triangle& t : shuffled.triangles) t = {number[t[1]], number[t[2]], number[t[0]]};
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);

  EXPECT_EQ(renumber(mesh), renumber(shuffled));
  EXPECT_EQ(mesh.points, shuffled.points);
  EXPECT_EQ(mesh.triangles, shuffled.triangles);
}

TEST(Renumber, KeepsTheTrianglesAndTheirOrientation)
{
  const SurfaceMesh before = aligned_grid({2, 1}, {6, 4}, Pattern::diagonal, Symmetry::none);
  SurfaceMesh after = before;
  renumber(after);
  const auto places = [](const SurfaceMesh& mesh) { // every triangle from its lowest, leftmost corner on
    std::vector<std::array<double, 6>> all;
    for (const Triangle& t : mesh.triangles) {
      std::array<std::array<double, 6>, 3> turned;
      for (int k = 0; k < 3; ++k) {
        for (int m = 0; m < 3; ++m) {
          turned[k][2 * m] = mesh.points[t[(k + m) % 3]].x;
          turned[k][2 * m + 1] = mesh.points[t[(k + m) % 3]].y;
        }
      }
      all.push_back(*std::min_element(turned.begin(), turned.end()));
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(places(before), places(after));
}

/// A grid's points, shuffled.
std::vector<Vec2> grid_points(int columns, int rows)
{
  std::vector<Vec2> points;
  for (int k = 0; k < columns * rows; ++k) points.push_back({double(k % columns), double(k / columns)});
  std::shuffle(points.begin(), points.end(), std::mt19937(7));
  return points;
}

TEST(Tiles, HoldEveryPointOnceInTilesOfNearlyEqualNumbers)
{
  const std::vector<Vec2> points = grid_points(127, 87);
  const Tiles tiles = tiles_of(points, 400);
  std::vector<int> sorted = tiles.order, all(points.size());
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  EXPECT_EQ(tiles.first.size(), 28u); // 11,049 points
  for (std::size_t t = 0; t < tiles.first.size(); ++t) {
    const int end = t + 1 < tiles.first.size() ? tiles.first[t + 1] : int(points.size());
    EXPECT_NEAR(end - tiles.first[t], 395, 60) << t;
  }
}

TEST(Tiles, OfAGridAreRectanglesOfRows)
{
  const std::vector<Vec2> points = grid_points(127, 87);
  const Tiles tiles = tiles_of(points, 400);
  for (std::size_t t = 0; t < tiles.first.size(); ++t) {
    const int begin = tiles.first[t], end = t + 1 < tiles.first.size() ? tiles.first[t + 1] : int(points.size());
    const Vec2 low = points[tiles.order[begin]], high = points[tiles.order[end - 1]];
    const int columns = int(high.x - low.x) + 1, rows = int(high.y - low.y) + 1;
    ASSERT_EQ(columns * rows, end - begin) << t;
    EXPECT_LT(std::max(columns, rows), 2 * std::min(columns, rows)) << t;
    for (int k = begin; k < end; ++k) {
      const Vec2& p = points[tiles.order[k]];
      EXPECT_EQ(p.x, low.x + (k - begin) % columns);
      EXPECT_EQ(p.y, low.y + (k - begin) / columns);
    }
  }
}

TEST(Tiles, TakeAnyPoints)
{
  EXPECT_TRUE(tiles_of({}, 10).order.empty());
  const std::vector<Vec2> one{{3, 4}}, same(25, Vec2{3, 4});
  EXPECT_EQ(tiles_of(one, 10).order, std::vector<int>{0});
  EXPECT_EQ(tiles_of(same, 10).order.size(), 25u);
  std::vector<Vec2> scattered;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> in(0.0, 1.0);
  for (int k = 0; k < 1000; ++k) scattered.push_back({in(random), in(random) * in(random)});
  const Tiles tiles = tiles_of(scattered, 100);
  ASSERT_EQ(tiles.first.size(), 10u);
  for (int t = 0; t < 10; ++t) EXPECT_NEAR(tiles.first[t], 100 * t, 5);
}

TEST(Renumber, TellsWhereTilesBegin)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {126, 86}, Pattern::diagonal, Symmetry::none);
  const std::vector<int> first = renumber(mesh);
  ASSERT_GT(first.size(), 10u);
  EXPECT_EQ(first.front(), 0);
  // The lowest corners of a tile's triangles are all below those of the next.
  int highest_before = -1;
  for (std::size_t t = 0; t < first.size(); ++t) {
    const int end = t + 1 < first.size() ? first[t + 1] : int(mesh.triangles.size());
    int lowest = int(mesh.points.size()), highest = 0;
    for (int e = first[t]; e < end; ++e) {
      lowest = std::min(lowest, mesh.triangles[e][0]);
      highest = std::max(highest, mesh.triangles[e][0]);
    }
    EXPECT_LT(highest_before, lowest);
    highest_before = highest;
  }
}

TEST(Renumber, KeepsTrianglesThatFollowEachOtherApart)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {126, 86}, Pattern::diagonal, Symmetry::none);
  renumber(mesh);
  int touching = 0;
  for (std::size_t e = 1; e < mesh.triangles.size(); ++e) {
    const Triangle &a = mesh.triangles[e - 1], &b = mesh.triangles[e];
    touching += std::any_of(a.begin(), a.end(), [&](int n) { return std::find(b.begin(), b.end(), n) != b.end(); });
  }
  EXPECT_LT(touching, int(mesh.triangles.size()) / 10);
}

TEST(Renumber, BringsNeighboursTogether)
{
  SurfaceMesh mesh = aligned_grid({1, 1}, {200, 200}, Pattern::diagonal, Symmetry::none);
  renumber(mesh);
  // Half of all triangles span no more numbers than a row of a tile, which is some twenty points wide, has; row by row all would span 201.
  std::vector<int> spans;
  for (const Triangle& t : mesh.triangles) spans.push_back(std::max(t[1], t[2]) - t[0]);
  std::nth_element(spans.begin(), spans.begin() + spans.size() / 2, spans.end());
  EXPECT_LE(spans[spans.size() / 2], 26);
}

} // namespace towform
