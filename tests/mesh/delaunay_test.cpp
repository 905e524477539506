#include "mesh/delaunay.hpp"
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <stdexcept>

namespace towform {
namespace {

__extension__ using Wide = __int128;

// Test points have whole coordinates of at most 2^20 and lie in a box of that size, corners included, so that
// the library's lattice holds them exactly and this file can judge them exactly.
constexpr int box = 1 << 20;

std::int64_t twice_area(const Vec2& a, const Vec2& b, const Vec2& c)
{
  return std::llround((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// The determinant of rows (x, y, x² + y²) of a, b, c seen from p; positive when p is inside.
Wide circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p)
{
  Wide m[3][3];
  int row = 0;
  for (const Vec2& q : {a, b, c}) {
    const auto x = std::llround(q.x - p.x), y = std::llround(q.y - p.y);
    m[row][0] = x;
    m[row][1] = y;
    m[row++][2] = static_cast<Wide>(x) * x + static_cast<Wide>(y) * y;
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Twice the area of the convex hull, by a monotone chain.
std::int64_t twice_hull_area(std::vector<Vec2> p)
{
  std::sort(p.begin(), p.end(),
            [](const Vec2& a, const Vec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::int64_t area = 0;
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<Vec2> chain;
    for (const Vec2& q : p) {
      while (chain.size() > 1 && twice_area(chain[chain.size() - 2], chain.back(), q) <= 0) chain.pop_back();
      chain.push_back(q);
    }
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) area += twice_area(chain[0], chain[k], chain[k + 1]);
    std::reverse(p.begin(), p.end());
  }
  // The two chains and the line between their ends enclose the hull.
  return area;
}

void expect_delaunay(const std::vector<Vec2>& points)
{
  const Triangulation r = delaunay(points);
  ASSERT_EQ(r.triangles.size(), r.neighbours.size());
  std::set<int> used;
  std::int64_t area = 0;
  int broken = 0, wrong_neighbours = 0;
  for (std::size_t t = 0; t < r.triangles.size(); ++t) {
    const auto [a, b, c] = r.triangles[t];
    used.insert({a, b, c});
    const std::int64_t one = twice_area(points[a], points[b], points[c]);
    ASSERT_GT(one, 0) << "triangle " << t;
    area += one;
    for (const Vec2& p : points) broken += circle(points[a], points[b], points[c], p) > 0;
    for (int k = 0; k < 3; ++k) {
      const int n = r.neighbours[t][k];
      if (n < 0) continue;
      const Triangle& other = r.triangles[n];
      const int from = r.triangles[t][(k + 1) % 3], to = r.triangles[t][(k + 2) % 3];
      bool found = false; // the same edge the other way round, pointing back
      for (int m = 0; m < 3; ++m) {
        found |= other[(m + 1) % 3] == to && other[(m + 2) % 3] == from &&
                 r.neighbours[n][m] == static_cast<int>(t);
      }
      wrong_neighbours += !found;
    }
  }
  EXPECT_EQ(broken, 0) << "points inside circles";
  EXPECT_EQ(wrong_neighbours, 0);
  EXPECT_EQ(used.size(), points.size());
  EXPECT_EQ(area, twice_hull_area(points));
}

Vec2 anywhere(std::mt19937& random)
{
  const auto x = static_cast<int>(random() % box), y = static_cast<int>(random() % box);
  return {static_cast<double>(x), static_cast<double>(y)};
}

std::vector<Vec2> corners() { return {{0, 0}, {box, 0}, {box, box}, {0, box}}; }

} // namespace

TEST(Delaunay, RandomPointsHaveEmptyCircles)
{
  std::mt19937 random(1);
  for (const int count : {1, 2, 5, 20, 100, 600}) {
    std::vector<Vec2> points = corners();
    for (int k = 0; k < count; ++k) {
      const Vec2 p = anywhere(random);
      points.push_back(p);
    }
    expect_delaunay(points);
  }
}

TEST(Delaunay, RandomHullsAreConvex)
{
  std::mt19937 random(2);
  std::vector<Vec2> points{{0, box / 2}, {box, box / 2}, {box / 2, 0}, {box / 2, box}};
  while (points.size() < 400) { // in a disc
    const Vec2 p = anywhere(random);
    if (std::hypot(p.x - box / 2, p.y - box / 2) < 0.49 * box) points.push_back(p);
  }
  expect_delaunay(points);
}

TEST(Delaunay, GridsFullOfTies)
{
  for (const int n : {1, 2, 4, 16}) {
    std::vector<Vec2> points;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) points.push_back({double(i * (box / n)), double(j * (box / n))});
    }
    expect_delaunay(points);
    EXPECT_EQ(delaunay(points).triangles.size(), 2u * n * n);
  }
}

TEST(Delaunay, PointsOnACircle)
{
  const int radius = 5 * 5 * 13 * 17; // many whole points lie at this distance from a whole point
  std::vector<Vec2> points = corners();
  for (int x = -radius; x <= radius; ++x) {
    const auto y = std::lround(std::sqrt(double(radius) * radius - double(x) * x));
    if (y * y + std::int64_t{x} * x != std::int64_t{radius} * radius) continue;
    points.push_back({double(box / 2 + x), double(box / 2 + y)});
    if (y != 0) points.push_back({double(box / 2 + x), double(box / 2 - y)});
  }
  ASSERT_GT(points.size(), 50u);
  expect_delaunay(points);
}

TEST(Delaunay, ManyPointsOnTheSides)
{
  std::vector<Vec2> points;
  const int n = 128;
  for (int k = 0; k < n; ++k) {
    const double t = double(k) * (box / n);
    points.insert(points.end(), {{t, 0}, {box, t}, {box - t, box}, {0, box - t}});
  }
  expect_delaunay(points); // nothing inside
  std::mt19937 random(3);
  for (int k = 0; k < 200; ++k) {
    const Vec2 p = anywhere(random);
    points.push_back(p);
  }
  expect_delaunay(points);
}

TEST(Delaunay, AThinStripAndALineWithOnePointOff)
{
  std::vector<Vec2> points;
  for (int k = 0; k <= 64; ++k) {
    points.push_back({double(k) * (box / 64), 0});
    points.push_back({double(k) * (box / 64), 1});
  }
  expect_delaunay(points);
  points.clear();
  for (int k = 0; k <= 64; ++k) points.push_back({double(k) * (box / 64), 0});
  points.push_back({5, 3});
  expect_delaunay(points);
}

TEST(Delaunay, RefusesPointsWithoutATriangulation)
{
  EXPECT_THROW(delaunay(std::vector<Vec2>{}), std::invalid_argument);
  EXPECT_THROW(delaunay(std::vector<Vec2>{{0, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(delaunay(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}), std::invalid_argument);
  EXPECT_THROW(delaunay(std::vector<Vec2>{{1, 1}, {1, 1}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(delaunay(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}, {1, 0}}), std::invalid_argument);
}

} // namespace towform
