#include "mesh/blank_grid.hpp"
#include "mesh/renumber.hpp"
#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace towform {

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

  EXPECT_EQ(renumber(mesh).triangles, renumber(shuffled).triangles);
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

TEST(Renumber, TellsWhereTilesBegin)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {126, 86}, Pattern::diagonal, Symmetry::none);
  const MeshTiles tiles = renumber(mesh);
  const std::vector<int>& first = tiles.triangles;
  ASSERT_GT(first.size(), 10u);
  ASSERT_EQ(tiles.nodes.size(), first.size());
  EXPECT_EQ(first.front(), 0);
  // The lowest corners of a tile's triangles are all below those of the next.
  int highest_before = -1;
  for (std::size_t t = 0; t < first.size(); ++t) {
    const int end = t + 1 < first.size() ? first[t + 1] : int(mesh.triangles.size());
    int lowest = int(mesh.points.size()), highest = 0;
    for (int e = first[t]; e < end; ++e) {
      const int corner = *std::min_element(mesh.triangles[e].begin(), mesh.triangles[e].end());
      lowest = std::min(lowest, corner);
      highest = std::max(highest, corner);
    }
    EXPECT_LT(highest_before, lowest);
    EXPECT_LE(tiles.nodes[t], lowest);
    if (t + 1 < first.size()) {
      EXPECT_GT(tiles.nodes[t + 1], highest);
    }
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
  // Half of all triangles span fewer numbers than four cells; row by row all would span 201.
  std::vector<int> spans;
  for (const Triangle& t : mesh.triangles) {
    const auto [low, high] = std::minmax_element(t.begin(), t.end());
    spans.push_back(*high - *low);
  }
  std::nth_element(spans.begin(), spans.begin() + spans.size() / 2, spans.end());
  EXPECT_LE(spans[spans.size() / 2], 24);
}

} // namespace towform
