#include "mesh/point_order.hpp"
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

TEST(Tiles, OfAGridAreRectangles)
{
  const std::vector<Vec2> points = grid_points(127, 87);
  const Tiles tiles = tiles_of(points, 400);
  for (std::size_t t = 0; t < tiles.first.size(); ++t) {
    const int begin = tiles.first[t], end = t + 1 < tiles.first.size() ? tiles.first[t + 1] : int(points.size());
    Vec2 low = points[tiles.order[begin]], high = low;
    for (int k = begin; k < end; ++k) {
      const Vec2& p = points[tiles.order[k]];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const int columns = int(high.x - low.x) + 1, rows = int(high.y - low.y) + 1;
    EXPECT_EQ(columns * rows, end - begin) << t;
    EXPECT_LT(std::max(columns, rows), 2 * std::min(columns, rows)) << t;
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

} // namespace towform
