#include "compare/made_sheets.hpp"
#include "compare/plan_search.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace towform {
namespace {

TEST(PlanSearch, FindsWhatAskingEveryTriangleFinds)
{
  SheetResult sheet = test::board(13, 7, {-0.05, 0.02});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> by(-0.02, 0.02), x(-0.08, 0.11), y(0.0, 0.12);
  for (Vec3& p : sheet.position) p += Vec3{by(random), by(random), by(random)}; // folded over itself
  const PlanSearch search(sheet.position, sheet.flat.triangles);
  std::size_t most = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec2 at{x(random), y(random)};
    std::vector<int> expected;
    for (std::size_t e = 0; e < sheet.flat.triangles.size(); ++e) {
      const Triangle& t = sheet.flat.triangles[e];
      const auto side = [&](int a, int b) {
        const Vec3 &p = sheet.position[t[a]], &q = sheet.position[t[b]];
        return (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x);
      };
      const double s[] = {side(0, 1), side(1, 2), side(2, 0)};
      if ((s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0))
        expected.push_back(static_cast<int>(e));
    }
    const auto holders = search.holders(at);
    std::vector<int> found;
    for (const auto& holder : holders) found.push_back(holder.element);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    EXPECT_TRUE(std::is_sorted(holders.begin(), holders.end(), [](auto& a, auto& b) { return a.z > b.z; }));
    most = std::max(most, found.size());
  }
  EXPECT_GT(most, 2U); // it was folded
}

TEST(PlanSearch, GivesTheHeightAndTakesEdgesAndCorners)
{
  SheetResult sheet = test::board(4, 4);
  for (Vec3& p : sheet.position) p.z = 2.0 * p.x - 3.0 * p.y;
  const PlanSearch search(sheet.position, sheet.flat.triangles);
  EXPECT_NEAR(search.holders({0.013, 0.024}).at(0).z, 2.0 * 0.013 - 3.0 * 0.024, 1e-15);
  EXPECT_EQ(search.holders({0.02, 0.02}).size(), 6U); // a node
  EXPECT_EQ(search.holders({0.04, 0.04}).size(), 2U); // the corner
  EXPECT_EQ(search.holders({0.0, 0.005}).size(), 1U);
  EXPECT_TRUE(search.holders({-1e-6, 0.005}).empty());
  EXPECT_TRUE(search.holders({0.04001, 0.02}).empty());
}

TEST(PlanSearch, UprightTrianglesHoldNothing)
{
  const std::vector<Vec3> wall{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}, {0.5, 1, 0}};
  const std::vector<Triangle> triangles{{0, 1, 2}, {0, 1, 3}};
  const auto holders = PlanSearch(wall, triangles).holders({0.5, 0.0});
  ASSERT_EQ(holders.size(), 1U);
  EXPECT_EQ(holders[0].element, 1);
}

} // namespace
} // namespace towform
