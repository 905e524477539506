#include "solver/bare_sheet.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <utility>

namespace towform {
namespace {

/// A smooth movement that is its own mirror image in x = 0 and y = 0.
Vec3 mirrored_speed(const Vec3& x)
{
  return {2.0 * std::sin(20.0 * x.x) * std::cos(30.0 * x.y), -std::sin(15.0 * x.y) * std::cos(25.0 * x.x),
          3.0 * std::cos(20.0 * x.x) * std::cos(35.0 * x.y)};
}

System after(const Model& model, double dt, int steps)
{
  System s = start(model);
  for (std::size_t n = 0; n < model.mass.size(); ++n)
    s.sheet.velocity[n] = mirrored_speed(model.blank.mesh.points[n]);
  test::step_on(model, s, dt, steps);
  return s;
}

TEST(MirrorPlanes, HoldTheirNodesAndNothingElse)
{
  for (const Symmetry symmetry : {Symmetry::x, Symmetry::y, Symmetry::quarter}) {
    Case c = test::bare_sheet();
    c.blank.symmetry = symmetry;
    const Model model = build_model(c);
    ASSERT_EQ(model.blank.mirror_x.empty(), symmetry == Symmetry::y);
    ASSERT_EQ(model.blank.mirror_y.empty(), symmetry == Symmetry::x);
    const System s = after(model, model.first_step, 300);
    double moved = 0.0;
    for (const int n : model.blank.mirror_x) {
      EXPECT_EQ(s.sheet.position[n].x, 0.0);
      moved = std::max(moved, std::abs(s.sheet.position[n].z));
    }
    for (const int n : model.blank.mirror_y) {
      EXPECT_EQ(s.sheet.position[n].y, 0.0);
      moved = std::max(moved, std::abs(s.sheet.position[n].z));
    }
    EXPECT_GT(moved, 1e-3); // free in the plane
  }
}

/// What the part moves as the whole does: the two meshes are one.
void compare_part_with_whole(double fibre_angle, Symmetry symmetry)
{
  Case c = test::bare_sheet();
  c.blank.fibre_angle = fibre_angle;
  c.blank.mesh_angle = -fibre_angle; // edges along the sides, so that the whole is its own mirror image
  const Model whole = build_model(c);
  c.blank.symmetry = symmetry;
  const Model part = build_model(c);
  const double dt = std::min(whole.first_step, part.first_step);
  const System of_whole = after(whole, dt, 300), of_part = after(part, dt, 300);
  std::map<std::pair<long, long>, std::size_t> at;
  const auto key = [](const Vec3& x) { return std::pair(std::lround(1e7 * x.x), std::lround(1e7 * x.y)); };
  for (std::size_t n = 0; n < whole.mass.size(); ++n) at[key(whole.blank.mesh.points[n])] = n;
  double worst = 0.0, moved = 0.0;
  for (std::size_t n = 0; n < part.mass.size(); ++n) {
    const auto found = at.find(key(part.blank.mesh.points[n]));
    ASSERT_NE(found, at.end());
    worst = std::max(worst, norm(of_whole.sheet.position[found->second] - of_part.sheet.position[n]));
    moved = std::max(moved, norm(of_part.sheet.position[n] - part.blank.mesh.points[n]));
  }
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(worst, 1e-9 * moved); // rounding, grown over 300 steps
  const double energy = energy_account(whole, of_whole).yarn;
  EXPECT_NEAR(energy_account(part, of_part).yarn, energy, 1e-7 * energy); // times two or four
}

TEST(MirrorPlanes, AHalfMovesAsTheWhole) { compare_part_with_whole(0.0, Symmetry::x); }
TEST(MirrorPlanes, AQuarterMovesAsTheWhole) { compare_part_with_whole(0.0, Symmetry::quarter); }
TEST(MirrorPlanes, AQuarterWithYarnsOnTheBiasMovesAsTheWhole)
{
  compare_part_with_whole(M_PI / 4.0, Symmetry::quarter);
}

} // namespace
} // namespace towform
