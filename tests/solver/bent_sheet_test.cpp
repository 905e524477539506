#include "solver/bare_sheet.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace towform {
namespace {

/// A free sheet so stiff in bending and so soft in its plane that bending sets the step.
Case stiff_sheet(Pattern pattern, double fibre_degrees)
{
  Case c = test::bare_sheet();
  c.blank.elements = 400;
  c.blank.pattern = pattern;
  c.blank.fibre_angle = fibre_degrees * M_PI / 180.0;
  c.material.fibre_modulus = 1e6;
  c.material.bending_stiffness = Vec2{1.0, 0.5};
  return c;
}

TEST(BentSheet, BendingLimitsTheStepAndTheBoundHolds)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured}) {
    const Model model = build_model(stiff_sheet(pattern, 30.0));
    const State flat = start(model).sheet;
    const StepBound bound(model.membrane, SheetMass{model.element_mass, model.mass}, model.shear_modulus, model.bending);
    const StepBound without(model.membrane, SheetMass{model.element_mass, model.mass}, model.shear_modulus);
    ASSERT_LT(bound.at(flat).step, 0.5 * without.at(flat).step);
    const auto growth = [&](double factor) {
      constexpr double so_little = 1e-3; // that the sheet stays flat
      return test::growth(model, factor * bound.at(flat).step, so_little, 50);
    };
    EXPECT_LT(growth(0.99), 1.05) << static_cast<int>(pattern);
    EXPECT_EQ(growth(2.0), HUGE_VAL) << static_cast<int>(pattern);
  }
}

TEST(BentSheet, BendingShareOfHeavierElements)
{
  Case c = stiff_sheet(Pattern::unstructured, 0.0);
  const double own = build_model(c).first_step;
  c.time.step = 1.5 * own;
  const Model model = build_model(c);
  EXPECT_GE(model.first_step, *c.time.step);
  EXPECT_GT(model.added_mass_fraction, 0.0);
  EXPECT_LT(model.added_mass_fraction, 1.5 * 1.5 - 1.0 + 0.01);
}

TEST(BentSheet, KeepsItsEnergyToSecondOrderInTheStep)
{
  const auto drift = [](double factor) {
    Case c = test::bare_sheet();
    c.material.bending_stiffness = Vec2{0.2, 0.1};
    c.time.subcycling = false;
    const Model model = build_model(c);
    System s = start(model);
    for (std::size_t n = 0; n < model.mass.size(); ++n) {
      const Vec3& x = model.blank.mesh.points[n];
      s.sheet.velocity[n] = {0.0, 0.0, 3.0 * std::cos(60.0 * x.x) * std::cos(70.0 * x.y)};
    }
    const double dt = factor * model.first_step;
    test::step_on(model, s, dt, 1);
    const double before = test::moving_energy(model, s);
    double worst = 0.0, bent = 0.0;
    for (int i = 0; i < 20; ++i) {
      test::step_on(model, s, dt, static_cast<int>(100.0 / factor));
      const Energies e = energy_account(model, s);
      worst = std::max(worst, std::abs((e.kinetic + e.internal() - e.bending_damping) / before - 1.0));
      worst = std::max(worst, std::abs(test::moving_energy(model, s) / before - 1.0));
      bent = std::max(bent, e.bending / before);
    }
    EXPECT_GT(bent, 0.05); // bending has its part
    return worst;
  };
  Case quiet = test::bare_sheet();
  EXPECT_EQ(quiet.material.bending_damping, 0.0);
  const double whole = drift(1.0), half = drift(0.5);
  EXPECT_LT(whole, 2e-3);
  EXPECT_NEAR(std::log2(whole / half), 2.0, 0.6);
}

TEST(BentSheet, HeldForcesMoveTheSheetAsThoseOfEveryStepDo)
{
  Case c = test::bare_sheet();
  c.material.bending_stiffness = Vec2{0.02, 0.01};
  c.material.bending_damping = 0.05;
  struct Swing {
    std::vector<Vec3> position;
    double drift = 0.0, bent = 0.0; // of the energy, over the first
  };
  const auto swing = [&](int expected_steps) {
    const Model model = build_model(c);
    EXPECT_EQ(model.bending.front().interval, expected_steps);
    System s = start(model);
    for (std::size_t n = 0; n < model.mass.size(); ++n) {
      const Vec3& x = model.blank.mesh.points[n];
      s.sheet.velocity[n] = {0.0, 0.0, std::cos(60.0 * x.x) * std::cos(70.0 * x.y)};
    }
    test::step_on(model, s, model.first_step, 8); // the account knows the curvatures of the last look
    const double before = test::moving_energy(model, s);
    Swing seen;
    for (int i = 0; i < 20; ++i) {
      test::step_on(model, s, model.first_step, 80);
      seen.drift = std::max(seen.drift, std::abs(test::moving_energy(model, s) / before - 1.0));
      seen.bent = std::max(seen.bent, energy_account(model, s).bending / before);
    }
    seen.position = s.sheet.position;
    return seen;
  };
  const Swing by_held = swing(8);
  c.time.subcycling = false;
  const Swing by_every_step = swing(1);
  EXPECT_GT(by_every_step.bent, 0.05);
  EXPECT_NEAR(by_held.bent, by_every_step.bent, 0.01 * by_every_step.bent);
  EXPECT_LT(by_held.drift, 2e-3);
  double apart = 0.0, height = 0.0;
  for (std::size_t n = 0; n < by_every_step.position.size(); ++n) {
    apart = std::max(apart, norm(by_held.position[n] - by_every_step.position[n]));
    height = std::max(height, std::abs(by_every_step.position[n].z));
  }
  EXPECT_LT(apart, 0.01 * height);
}

TEST(BentSheet, HeldForcesFeedNoWaves)
{
  Case c = test::bare_sheet();
  c.material.bending_stiffness = Vec2{0.02, 0.02};
  c.material.bending_damping = 0.01;
  const Model model = build_model(c);
  ASSERT_GT(model.bending.front().interval, 1);
  System s = start(model);
  test::shake(s, 1e-3);
  const auto bent = [&](int steps) { // that of bending alone, and of the motion across the sheet
    test::step_on(model, s, model.first_step, steps);
    double sum = energy_account(model, s).bending;
    for (std::size_t n = 0; n < model.mass.size(); ++n)
      sum += 0.5 * model.mass[n] * s.sheet.velocity[n].z * s.sheet.velocity[n].z;
    return sum;
  };
  const double before = bent(model.bending.front().interval);
  for (int i = 0; i < 100; ++i) EXPECT_LT(bent(200), 1.02 * before) << i;
}

TEST(BentSheet, IsBentAtEveryStepWhereThatMatters)
{
  EXPECT_EQ(build_model(stiff_sheet(Pattern::diagonal, 0.0)).bending.front().interval, 1);
  Case c = test::bare_sheet();
  c.material.bending_stiffness = Vec2{0.02, 0.02};
  EXPECT_EQ(build_model(c).bending.front().interval, 1); // nothing would take away what held forces feed
  c.material.bending_damping = 0.05;
  c.time.safety = 0.8;
  EXPECT_EQ(build_model(c).bending.front().interval, 8);
}

TEST(BentSheet, DampingTakesTheFlutterAndIsAccountedFor)
{
  Case c = test::bare_sheet();
  c.material.bending_stiffness = Vec2{0.2, 0.2};
  c.material.bending_damping = 0.05;
  c.time.subcycling = false;
  const Model model = build_model(c);
  System s = start(model);
  test::shake(s, 0.5);
  for (Vec3& v : s.sheet.velocity) v = {0.0, 0.0, v.z};
  test::step_on(model, s, model.first_step, 1);
  const double before = test::moving_energy(model, s);
  test::step_on(model, s, model.first_step, 4000);
  const Energies e = energy_account(model, s);
  EXPECT_NEAR(test::moving_energy(model, s), before, 2e-3 * before);
  EXPECT_GT(e.bending_damping, 0.5 * before); // random zigzags are its fastest waves
}

TEST(BentSheet, FallsFreelyUnderGravityAndTheWorkIsAccountedFor)
{
  Case c = test::bare_sheet();
  c.material.bending_stiffness = Vec2{1e-3, 1e-3};
  c.load.gravity = {0.0, 1.0, -9.81};
  c.time.mass_scaling = 1.0;
  const Model model = build_model(c);
  System s = start(model);
  test::step_on(model, s, model.first_step, 1000);
  // The first kick is half a step long: central differences fall exactly as they should.
  const double fallen = 0.5 * s.sheet.time * s.sheet.time;
  for (std::size_t n = 0; n < model.mass.size(); ++n) {
    const Vec3 moved = s.sheet.position[n] - model.blank.mesh.points[n];
    EXPECT_LT(norm(moved - fallen * c.load.gravity), 1e-9 * fallen + 1e-13);
  }
  const Energies e = energy_account(model, s);
  EXPECT_NEAR(e.external, 0.1 * 0.08 * 1.48 * norm_squared(c.load.gravity) * fallen, 1e-9 * e.external);
  EXPECT_LT(e.error(), 1e-6); // v_(n-1/2) . v_(n+1/2) is v^2 less (g dt/2)^2
}

TEST(BentSheet, ScaledMassDoesNotWeighMore)
{
  Case c = test::bare_sheet();
  c.load.gravity = {0.0, 0.0, -9.81};
  c.time.mass_scaling = 50.0;
  const Model model = build_model(c);
  Vec3 weight;
  for (const Vec3& w : model.gravity.front().weight) weight += w;
  EXPECT_NEAR(weight.z, -9.81 * 1.48 * 0.1 * 0.08, 1e-12);
}

TEST(BentSheet, SheetWithoutBendingHasNoneOfItsArrays)
{
  const Model model = build_model(test::bare_sheet());
  EXPECT_TRUE(model.bending.empty());
  EXPECT_TRUE(model.gravity.empty());
  EXPECT_TRUE(start(model).bending.empty());
}

} // namespace
} // namespace towform
