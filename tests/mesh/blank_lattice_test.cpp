#include "mesh/blank_lattice.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace towform {

TEST(Lattice, RowsHoldThePointsInsideAndNoOthers)
{
  const Rectangle inside{{-0.7, -0.4}, {1.1, 0.9}};
  for (const bool staggered : {false, true}) {
    for (const double angle : {0.0, 0.3, 0.7853981633974483, 2.0, -1.2}) {
      const Lattice lattice{angle, 0.05, 0.083, staggered};
      std::int64_t counted = 0;
      for (const LatticeRow& row : lattice_rows(lattice, inside)) counted += row.count;
      std::int64_t expected = 0;
      for (int row = -60; row <= 60; ++row) {
        for (int column = -60; column <= 60; ++column) {
          if (staggered && (row + column) % 2 != 0) continue;
          const Vec2 p = lattice_point(lattice, column, row);
          expected +=
              p.x >= inside.low.x && p.x <= inside.high.x && p.y >= inside.low.y && p.y <= inside.high.y;
        }
      }
      EXPECT_NEAR(static_cast<double>(counted), static_cast<double>(expected), angle == 0.0 ? 31 : 0);
    }
  }
}

TEST(Lattice, AnEmptyRectangleHasNoRows)
{
  EXPECT_TRUE(lattice_rows({0.3, 0.1, 0.1, false}, {{1, 1}, {-1, 2}}).empty());
}

TEST(DividedSides, AreEvenAndExactAtTheCorners)
{
  const std::vector<Vec2> points = divided_sides({{-0.3, -0.1}, {0.3, 0.1}}, {0.11});
  ASSERT_EQ(points.size(), 14u); // 5 + 2 + 5 + 2
  EXPECT_EQ(points[0], (Vec2{-0.3, -0.1}));
  EXPECT_EQ(points[5], (Vec2{0.3, -0.1}));
  EXPECT_EQ(points[7], (Vec2{0.3, 0.1}));
  EXPECT_EQ(points[12], (Vec2{-0.3, 0.1}));
  EXPECT_NEAR(points[1].x, -0.18, 1e-15);
  EXPECT_EQ(points[1].y, -0.1);
}

TEST(DividedSides, MirrorPlanesTakeMultiplesOfTheirGap)
{
  const std::vector<Vec2> points = divided_sides({{0.0, -1.0}, {1.0, 1.0}}, {1.0, 0.0, 0.4});
  const std::vector<Vec2> expected{{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {0, 0.4}, {0, 0}, {0, -0.4}};
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(points[k], expected[k]);
}

TEST(EdgeForCount, FindsTheNearestCountOfAStaircase)
{
  const auto count = [](double edge) { return 2 * static_cast<std::int64_t>(1.0 / edge) * 7; };
  const double edge = edge_for_count(1003.0, 0.02, count);
  EXPECT_EQ(count(edge), 1008);
}

} // namespace towform
