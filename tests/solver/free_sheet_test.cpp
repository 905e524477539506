#include "solver/bare_sheet.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

TEST(FreeSheet, FliesStraightWithoutLoad)
{
  const Model model = build_model(test::bare_sheet());
  System s = start(model);
  const Vec3 speed{3.0, -2.0, 5.0};
  for (Vec3& v : s.sheet.velocity) v = speed;
  test::step_on(model, s, model.first_step, 500);
  for (std::size_t n = 0; n < model.mass.size(); ++n) {
    const Vec3 expected = model.blank.mesh.points[n] + s.sheet.time * speed;
    EXPECT_LT(norm(s.sheet.position[n] - expected), 1e-11); // 500 roundings of positions of order 0.1 m
  }
}

TEST(FreeSheet, KeepsItsMomentumWhileItVibrates)
{
  const Model model = build_model(test::bare_sheet());
  System s = start(model);
  test::shake(s, 2.0);
  for (Vec3& v : s.sheet.velocity) v += {3.0, -2.0, 5.0};
  const Vec3 before = test::momentum(model, s);
  test::step_on(model, s, model.first_step, 500);
  EXPECT_LT(norm(test::momentum(model, s) - before), 1e-12 * norm(before));          // internal forces cancel
  EXPECT_GT(energy_account(model, s).yarn, 0.01 * energy_account(model, s).kinetic); // it did vibrate
}

/// Largest relative change of the energy of a sheet over `periods` of its slowest in-plane mode, in steps of
/// `factor` times the model's; `across` is the speed of waves out of its plane [m/s].
double energy_drift(double factor, double across, int periods)
{
  const Model model = build_model(test::bare_sheet());
  System s = start(model);
  for (std::size_t n = 0; n < model.mass.size(); ++n) {
    const Vec3& x = model.blank.mesh.points[n];
    s.sheet.velocity[n] = {2.0 * std::sin(31.4 * x.x), 1.5 * std::sin(39.3 * x.y),
                           across * std::cos(60.0 * x.x) * std::cos(70.0 * x.y)};
  }
  const double dt = factor * model.first_step;
  // The first velocities count as v_(-1/2) of a step that has not been made: take the account after one step.
  test::step_on(model, s, dt, 1);
  const double before = test::moving_energy(model, s);
  const double slowest_period = 2.0 * 0.1 / std::sqrt(1e9 / 1480.0); // free-free along x
  const int steps_a_period = static_cast<int>(slowest_period / dt) + 1;
  double worst = 0.0;
  for (int period = 0; period < periods; ++period) {
    test::step_on(model, s, dt, steps_a_period);
    worst = std::max(worst, std::abs(test::moving_energy(model, s) / before - 1.0));
  }
  return worst;
}

TEST(FreeSheet, KeepsItsEnergyWhileItVibrates)
{
  // Near the stable limit the account is a small difference of large numbers; well below it the drift is that
  // of strains of 0.2 % in a law that is linear in the stretch.
  const double worst = energy_drift(0.5, 0.0, 60);
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(worst, 0.0); // it is not frozen
}

TEST(FreeSheet, KeepsItsEnergyToSecondOrderInTheStepWhereGeometryCounts)
{
  // Waves of 2 m/s across the sheet turn its yarns by tenths: what is kept is an energy within O(dt^2) of
  // ours.
  const double whole = energy_drift(1.0, 2.0, 6), half = energy_drift(0.5, 2.0, 6);
  EXPECT_LT(whole, 1e-3);
  EXPECT_NEAR(std::log2(whole / half), 2.0, 0.5);
}

/// Frequency of the first longitudinal mode of a strip of length 0.1 m with `elements` triangles, from the
/// zero crossings of its amplitude over ten periods [1/s].
double longitudinal_frequency(int elements)
{
  Case c = test::bare_sheet();
  c.blank.size = {0.1, 0.02};
  c.blank.elements = elements;
  const Model model = build_model(c);
  System s = start(model);
  const double length = c.blank.size.x;
  const auto mode = [&](std::size_t n) { return std::sin(M_PI * model.blank.mesh.points[n].x / length); };
  for (std::size_t n = 0; n < model.mass.size(); ++n) s.sheet.velocity[n].x = 1e-3 * mode(n);
  const auto amplitude = [&] {
    double sum = 0.0;
    for (std::size_t n = 0; n < model.mass.size(); ++n)
      sum += model.mass[n] * mode(n) * (s.sheet.position[n].x - model.blank.mesh.points[n].x);
    return sum;
  };
  // At the stable limit errors of space and time cancel on such a grid: a small step leaves those of space.
  const double dt = 0.2 * model.first_step;
  test::step_on(model, s, dt, 1);
  constexpr int periods = 10;
  double last = amplitude(), first_crossing = 0.0, crossing = 0.0;
  for (int crossings = 0; crossings <= 2 * periods;) {
    test::step_on(model, s, dt, 1);
    const double now = amplitude();
    if (last * now < 0.0) {
      crossing = s.sheet.time - dt * now / (now - last);
      if (crossings++ == 0) first_crossing = crossing;
    }
    last = now;
  }
  return periods / (crossing - first_crossing);
}

TEST(FreeSheet, VibratesAlongItsYarnsAtTheExactFrequency)
{
  const double exact = std::sqrt(1e9 / 1480.0) / (2.0 * 0.1);
  std::vector<double> errors;
  for (const int elements : {160, 640, 2560}) { // edges of 5, 2.5 and 1.25 mm
    errors.push_back(longitudinal_frequency(elements) / exact - 1.0);
  }
  EXPECT_LT(std::abs(errors[2]), 2e-4);
  for (int i : {0, 1}) {
    const double order = std::log2(errors[i] / errors[i + 1]);
    EXPECT_NEAR(order, 2.0, 0.3) << "from mesh " << i;
  }
}

} // namespace
} // namespace towform
