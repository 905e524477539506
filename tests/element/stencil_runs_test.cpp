#include "element/stencil_runs.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace towform {
namespace {

/// Nodes 0 .. 35 in six rows, in the middle of points in eight; the patch of a node is a cross.
struct Cross {
  std::vector<Vec3> flat;
  std::vector<CurvaturePatch> patches;
  std::vector<int> points;

  explicit Cross(double spread)
  {
    std::vector<int> number(64, -1);
    const auto at = [&](int row, int column) -> int& { return number[8 * row + column]; };
    const auto add = [&](int row, int column) {
      at(row, column) = static_cast<int>(flat.size());
      flat.push_back({0.01 * column, 0.02 * row, 0.0});
    };
    for (int row = 1; row < 7; ++row)
      for (int column = 1; column < 7; ++column) add(row, column);
    for (int i = 0; i < 64; ++i)
      if (number[i] < 0) add(i / 8, i % 8);
    for (int row = 1; row < 7; ++row)
      for (int column = 1; column < 7; ++column) {
        const std::vector<int> its{at(row, column), at(row, column - 1), at(row, column + 1), at(row - 1, column), at(row + 1, column)};
        const double c = 1.0 + spread * row * column; // one vector's multiple
        patches.emplace_back(its, std::vector<double>{-2.0, 1.0 + c, 1.0 - c, 0.0, 0.0}, std::vector<double>{-2.0, c, -c, 1.0, 1.0},
                             std::array{its[1], its[2], its[3], its[4]});
      }
    points.resize(flat.size());
    std::iota(points.begin(), points.end(), 0);
  }
};

TEST(StencilRuns, HoldNodesWhosePatchesReachAlike)
{
  for (const double spread : {0.0, 0.1}) {
    const Cross sheet(spread);
    const StencilLayout layout = find_runs(sheet.patches, 0, sheet.points, sheet.flat);
    ASSERT_EQ(layout.runs.size(), 1U);
    const StencilRun& run = layout.runs.front();
    EXPECT_EQ(run.times.empty(), spread == 0.0);
    int nodes = 0;
    for (std::size_t i = 0; i < run.nodes.size(); ++i) {
      if (run.nodes[i] < 0) continue;
      ++nodes;
      EXPECT_EQ(layout.lane[static_cast<std::size_t>(run.nodes[i])], run.first_lane + static_cast<int>(i));
      const CurvaturePatch& patch = sheet.patches[static_cast<std::size_t>(run.nodes[i])];
      for (std::size_t k = 0; k < patch.points.size(); ++k) {
        const int ahead = layout.lane[static_cast<std::size_t>(patch.points[k])] - run.first_lane - static_cast<int>(i);
        const auto point = std::find_if(run.points.begin(), run.points.end(), [&](const StencilPoint& p) { return p.ahead == ahead; });
        ASSERT_NE(point, run.points.end());
        const YarnPair times = run.times.empty() ? YarnPair{} : run.times[i];
        EXPECT_NEAR(point->warp + times.warp * point->change, patch.weights[k].warp, 1e-10);
        EXPECT_NEAR(point->weft + times.weft * point->change, patch.weights[k].weft, 1e-10);
      }
    }
    EXPECT_EQ(nodes, 36);
  }
}

TEST(StencilRuns, PointsInOnePlaceHaveLanesOfTheirOwn)
{
  Cross sheet(0.0);
  sheet.flat.push_back(sheet.flat[14]); // an image that lies on a node, and belongs to another one's patch
  sheet.points.push_back(64);
  std::replace(sheet.patches[15].points.begin(), sheet.patches[15].points.end(), 14, 64);
  const StencilLayout layout = find_runs(sheet.patches, 0, sheet.points, sheet.flat);
  std::vector<std::uint16_t> lanes = layout.lane;
  std::sort(lanes.begin(), lanes.end());
  EXPECT_EQ(std::adjacent_find(lanes.begin(), lanes.end()), lanes.end());
  EXPECT_LT(lanes.back(), layout.lanes);
  ASSERT_EQ(layout.runs.size(), 1U);
  const std::vector<int>& nodes = layout.runs.front().nodes;
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), 15), 0);
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), -1) + 35, static_cast<int>(nodes.size()));
}

} // namespace
} // namespace towform
