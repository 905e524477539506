#include "compare/made_sheets.hpp"
#include "compare/section.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

std::vector<SectionPiece> cut(const SheetResult& sheet, Vec2 from, Vec2 to, bool left = true)
{
  return cut_section(sheet.position, sheet.flat.triangles, from, to, left);
}

/// Pieces follow one another without a gap and lie on the plane.
void expect_whole(const std::vector<SectionPiece>& section, double length)
{
  ASSERT_FALSE(section.empty());
  EXPECT_EQ(section.front().arc_from, 0.0);
  for (std::size_t i = 1; i < section.size(); ++i) {
    EXPECT_LT(norm(section[i].from - section[i - 1].to), 1e-15);
    EXPECT_NEAR(section[i].arc_from, section[i - 1].arc_to, 1e-15);
  }
  EXPECT_NEAR(section.back().arc_to, length, 1e-14);
}

TEST(Section, HasTheLengthOfTheSurface)
{
  SheetResult roof = test::board(8, 6); // the ridge along x = 0.04, one up on two
  for (Vec3& p : roof.position) p.z = -0.5 * std::abs(p.x - 0.04);
  const double steep = std::sqrt(1.25);
  expect_whole(cut(roof, {0.001, 0.033}, {0.079, 0.033}), steep * 0.078);
  expect_whole(cut(roof, {0.079, 0.033}, {0.001, 0.033}), steep * 0.078); // the other way
  // Oblique: plan length 50, of which 30 in x; ends inside triangles.
  expect_whole(cut(roof, {0.005, 0.012}, {0.035, 0.052}), std::hypot(0.05, 0.5 * 0.03));
  expect_whole(cut(roof, {0.041, 0.012}, {0.041, 0.052}), 0.04); // along the ridge's side
}

TEST(Section, AlongMeshLinesHasEachSideOnce)
{
  const SheetResult sheet = test::board(8, 6);
  for (const auto& [from, to] :
       {std::pair{Vec2{0.0, 0.03}, Vec2{0.08, 0.03}}, std::pair{Vec2{0.0, 0.0}, Vec2{0.06, 0.06}},
        std::pair{Vec2{0.0, 0.03 + 1e-17}, Vec2{0.08, 0.03 - 1e-17}}}) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    for (const bool left : {true, false}) expect_whole(cut(sheet, from, to, left), length);
    const auto a = cut(sheet, from, to, true), b = cut(sheet, from, to, false);
    double on_both = 0.0;
    for (const SectionPiece& p : a)
      for (const SectionPiece& q : b)
        if (p.element == q.element && p.arc_to > p.arc_from && q.arc_to > q.arc_from) on_both += 1.0;
    EXPECT_EQ(on_both, 0.0);
  }
  // On the outline there is a sheet on one side only.
  expect_whole(cut(sheet, {0.0, 0.0}, {0.08, 0.0}, true), 0.08);
  EXPECT_TRUE(cut(sheet, {0.0, 0.0}, {0.08, 0.0}, false).empty());
}

TEST(Section, GoesStraightAcrossHolesAndBeginsAtTheEdge)
{
  SheetResult sheet = test::board(8, 6);
  // Without the squares 3 and 4 of the row j = 2.
  std::erase_if(sheet.flat.triangles, [&](const Triangle& t) {
    const Vec3 middle =
        (1.0 / 3.0) * (sheet.flat.points[t[0]] + sheet.flat.points[t[1]] + sheet.flat.points[t[2]]);
    return middle.x > 0.03 && middle.x < 0.05 && middle.y > 0.02 && middle.y < 0.03;
  });
  const auto section = cut(sheet, {-0.02, 0.024}, {0.09, 0.024});
  EXPECT_EQ(section.front().arc_from, 0.0);
  EXPECT_NEAR(section.front().along_from, 0.02, 1e-15);
  EXPECT_NEAR(section.back().arc_to, 0.08, 1e-15);
  double inside = 0.0;
  for (const SectionPiece& p : section) inside += p.arc_to - p.arc_from;
  EXPECT_NEAR(inside, 0.06, 1e-15);
}

TEST(Section, FollowsAnOverhang)
{
  // A strip in the shape of an S seen from the side: forward, back above itself, forward again.
  SheetResult sheet = test::board(3, 1);
  const double x[] = {0.0, 0.03, 0.01, 0.04}, z[] = {0.0, 0.0, 0.01, 0.02};
  for (std::size_t n = 0; n < 8; ++n) sheet.position[n] = {x[n % 4], sheet.position[n].y, z[n % 4]};
  const double length = 0.03 + std::hypot(0.02, 0.01) + std::hypot(0.03, 0.01);
  expect_whole(cut(sheet, {0.0, 0.004}, {0.04, 0.004}), length);
}

TEST(Section, OffTheSheetIsEmpty)
{
  const SheetResult sheet = test::board(3, 3);
  EXPECT_TRUE(cut(sheet, {0.0, 0.05}, {0.03, 0.05}).empty());
  EXPECT_TRUE(cut(sheet, {0.04, 0.01}, {0.09, 0.01}).empty());
}

} // namespace
} // namespace towform
