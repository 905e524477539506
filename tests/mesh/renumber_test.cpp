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

  renumber(mesh);
  renumber(shuffled);
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
  EXPECT_TRUE(std::is_sorted(after.triangles.begin(), after.triangles.end()));
}

TEST(Renumber, BringsNeighboursTogether)
{
  SurfaceMesh mesh = aligned_grid({1, 1}, {200, 200}, Pattern::diagonal, Symmetry::none);
  renumber(mesh);
  // Half of all triangles span fewer numbers than four cells; row by row all would span 201.
  std::vector<int> spans;
  for (const Triangle& t : mesh.triangles) spans.push_back(std::max(t[1], t[2]) - t[0]);
  std::nth_element(spans.begin(), spans.begin() + spans.size() / 2, spans.end());
  EXPECT_LE(spans[spans.size() / 2], 24);
}

} // namespace towform
