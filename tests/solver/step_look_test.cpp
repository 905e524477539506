#include "solver/step_look.hpp"
#include "solver/press_case.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

/// The press with its sheet folded like a bellows: what tools do square to it counts there.
class StepLookTest : public Press {
protected:
  StepLookTest() : model(build_model(read({"contact.penalty=1"}))), s(at_rest(model))
  {
    for (Vec3& p : s.sheet.position) p.z += 4e-3 * std::cos(M_PI * p.x / 10e-3); // from node to node
    start(model.membrane, s.sheet);
  }
  /// How many tools touch the nodes on one side.
  void touch(int tools, bool left)
  {
    for (int i = 0; i < tools; ++i)
      for (std::size_t n = 0; n < s.sheet.position.size(); ++n)
        if ((s.sheet.position[n].x < 0.0) == left) s.contacts[static_cast<std::size_t>(i)].normal_force[n] = 1.0;
  }
  double look()
  {
    const StepBound bound(model.membrane, {model.element_mass, model.mass}, model.shear_modulus);
    last = {1.0, 1.0}; // of another shape
    look_at_step(model, bound, s, last);
    return last.step;
  }
  [[nodiscard]] double limit(double tools) const
  {
    const StepLimit its(model.blank, model.membrane, model.mass, model.shear_modulus, {}, model.tool_springs);
    return its.at(s.sheet.position, std::vector<double>(model.mass.size(), tools));
  }

  Model model;
  System s;
  StepLook last;
};

TEST_F(StepLookTest, TakesEveryNodeToTouchATool)
{
  const double free = look();
  EXPECT_NEAR(free, limit(1.0), 0.01 * free);
  touch(1, true);
  EXPECT_EQ(look(), free);
}

TEST_F(StepLookTest, CountsSecondToolsWhereTheyTouch)
{
  const double one = look();
  touch(2, true);
  touch(2, false);
  s.touched.more = true;
  const double two = look();
  EXPECT_FALSE(s.touched.more);
  EXPECT_NEAR(two, limit(2.0), 0.01 * two);
  EXPECT_LT(two, 0.97 * one);
}

TEST_F(StepLookTest, CountsTheSurroundingsOfWhoTouchesTheMoreTheOftenerOthersFollow)
{
  touch(2, true);
  const auto counted = [&](bool more) {
    s.touched.more = more;
    look();
    const std::vector<double>& of = s.touched.counted;
    return std::count(of.begin(), of.end(), 2.0);
  };
  const auto touching = std::count_if(s.sheet.position.begin(), s.sheet.position.end(), [](const Vec3& p) { return p.x < 0.0; });
  const auto few = counted(false);
  EXPECT_GT(few, touching);
  EXPECT_LT(few, std::ssize(s.sheet.position));
  EXPECT_GT(counted(true), few);
  for (int i = 0; i < 6; ++i) counted(true);
  EXPECT_EQ(counted(true), std::ssize(s.sheet.position));
  for (int i = 0; i < 6; ++i) counted(false);
  EXPECT_EQ(counted(false), few);
}

} // namespace
} // namespace towform
