#include "element/bent.hpp"
#include "element/sheet.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

using test::degree;
using test::meshes;
using test::named;

TEST(Curvature, IsExactForEveryQuadraticOnEveryMesh)
{
  for (const auto& [pattern, angle] : meshes) {
    const Blank blank = test::blank(pattern, 20.0 * degree, angle * degree);
    const CurvatureOperator op(blank, {}, 20);
    ASSERT_TRUE(op.complete());
    const auto field = [](const Vec3& p) {
      return 1.0 + 2.0 * p.x - p.y + 3.0 * p.x * p.x - 4.0 * p.x * p.y + 5.0 * p.y * p.y;
    };
    const auto second = [](const Vec3& f) { return 6.0 * f.x * f.x - 8.0 * f.x * f.y + 10.0 * f.y * f.y; };
    std::size_t nodes = 0;
    test::each_node(op, [&](int, int, const CurvatureOperator::Patch& patch) {
      double warp = 0.0, weft = 0.0;
      patch.each_term([&](int point, const YarnPair& weight) {
        warp += weight.warp * field(blank.mesh.points[point]);
        weft += weight.weft * field(blank.mesh.points[point]);
      });
      // Weights are of order 1e5 1/m^2 on values of order 1.
      EXPECT_NEAR(warp, second(blank.warp), 1e-9) << named(pattern, angle);
      EXPECT_NEAR(weft, second(blank.weft), 1e-9) << named(pattern, angle);
      ++nodes;
    });
    EXPECT_EQ(nodes, op.nodes());
  }
}

TEST(Curvature, NodesOfARegularMeshStandInRuns)
{
  // Balanced moments leave no two patches near an edge quite alike.
  const auto alone = [](Pattern pattern, int balance) {
    const CurvatureOperator op(test::blank(pattern, 0.0, 0.0, 4000), {}, balance);
    return static_cast<double>(op.ends.size()) / static_cast<double>(op.nodes());
  };
  for (const int balance : {0, 50}) {
    EXPECT_LT(alone(Pattern::diagonal, balance), 0.2); // edges, and the lines where diagonals turn
    EXPECT_EQ(alone(Pattern::unstructured, balance), 1.0);
  }
}

TEST(Curvature, SinglePatchesThatAreAlikeShareTheirWeights)
{
  const CurvatureOperator op(test::blank(Pattern::cross, 0.0, 0.0, 4000), {}, 0);
  EXPECT_LT(static_cast<double>(op.weight.size()) / static_cast<double>(op.point.size()), 0.02);
}

TEST(Curvature, NeedsEnoughNodes)
{
  BlankParameters p;
  p.size = {0.1, 0.1};
  p.edge = 0.1;
  p.thickness = 1e-3;
  const Blank coarse = make_blank(p); // nine nodes at most
  Blank two = coarse;
  two.mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  two.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_FALSE(CurvatureOperator(two, {}, 0).complete());
  EXPECT_THROW(test::bending_of(two, 1e-3, 1e-3), std::invalid_argument);
}

} // namespace
} // namespace towform
