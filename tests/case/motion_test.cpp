#include "towform/motion.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {

namespace {

Motion displaced(Motion::Profile profile)
{
  Motion motion;
  motion.profile = profile;
  motion.amount = -0.06;
  motion.duration = 0.05;
  return motion;
}

Motion by_table(Motion::Quantity quantity, std::vector<Motion::Point> table)
{
  Motion motion;
  motion.quantity = quantity;
  motion.profile = Motion::Profile::table;
  motion.table = std::move(table);
  return motion;
}

} // namespace

TEST(Motion, UnitVectors)
{
  EXPECT_EQ(unit_vector(Axis::x), (Vec3{1, 0, 0}));
  EXPECT_EQ(unit_vector(Axis::y), (Vec3{0, 1, 0}));
  EXPECT_EQ(unit_vector(Axis::z), (Vec3{0, 0, 1}));
}

TEST(Motion, DisplacementBeginsAtZeroAndEndsExactly)
{
  for (const auto profile : {Motion::Profile::constant, Motion::Profile::smooth}) {
    const Motion motion = displaced(profile);
    EXPECT_EQ(motion.displacement(-1.0), 0.0);
    EXPECT_EQ(motion.displacement(0.0), 0.0);
    EXPECT_EQ(motion.displacement(0.05), -0.06);
    EXPECT_EQ(motion.displacement(1.0), -0.06); // held
    EXPECT_DOUBLE_EQ(motion.displacement(0.025), -0.03);
  }
}

TEST(Motion, ContinuousAndMonotonic)
{
  for (const auto profile : {Motion::Profile::constant, Motion::Profile::smooth}) {
    const Motion motion = displaced(profile);
    const double largest = 1.875 * 0.06 / 0.05; // peak speed of the quintic is 15/8 of the mean
    for (int i = -100; i < 1100; ++i) {
      const double t = 0.05 * i / 1000, dt = 0.05 / 1000;
      const double moved = motion.displacement(t) - motion.displacement(t + dt);
      EXPECT_GE(moved, 0.0);
      EXPECT_LE(moved, largest * dt * (1 + 1e-9));
    }
  }
}

TEST(Motion, SmoothStartsAndStopsAtRest)
{
  const Motion motion = displaced(Motion::Profile::smooth);
  const double h = 1e-3 * motion.duration;
  // Speed and acceleration vanish at both ends: what is left is the cubic term 10 s^3.
  EXPECT_NEAR(motion.displacement(h) / motion.amount, 1e-8, 1e-10);
  EXPECT_NEAR(1.0 - motion.displacement(motion.duration - h) / motion.amount, 1e-8, 1e-10);
  // Its largest speed is in the middle.
  const double mid = 0.5 * motion.duration;
  const double speed = (motion.displacement(mid + h) - motion.displacement(mid - h)) / (2 * h);
  EXPECT_NEAR(speed, 1.875 * motion.amount / motion.duration, 1e-5 * std::abs(speed));
}

TEST(Motion, ConstantVelocity)
{
  Motion motion;
  motion.quantity = Motion::Quantity::velocity;
  motion.amount = -2.0;
  motion.duration = 0.5;
  EXPECT_EQ(motion.displacement(0.0), 0.0);
  EXPECT_EQ(motion.displacement(0.25), -0.5);
  EXPECT_EQ(motion.displacement(1.0), -2.0);
}

TEST(Motion, TableOfDisplacements)
{
  const Motion motion = by_table(Motion::Quantity::displacement, {{1.0, 2.0}, {3.0, 6.0}, {4.0, -1.0}});
  EXPECT_EQ(motion.displacement(0.0), 2.0); // held before the first point
  EXPECT_EQ(motion.displacement(1.0), 2.0);
  EXPECT_EQ(motion.displacement(2.0), 4.0);
  EXPECT_EQ(motion.displacement(3.0), 6.0);
  EXPECT_EQ(motion.displacement(3.5), 2.5);
  EXPECT_EQ(motion.displacement(4.0), -1.0);
  EXPECT_EQ(motion.displacement(9.0), -1.0); // and after the last
}

TEST(Motion, TableOfVelocitiesIsIntegratedExactly)
{
  // v = 2 up to 1 s, then 2 + 2 (t - 1) up to 6 at 3 s, then down to -1 at 4 s, then -1.
  const Motion motion = by_table(Motion::Quantity::velocity, {{1.0, 2.0}, {3.0, 6.0}, {4.0, -1.0}});
  EXPECT_EQ(motion.displacement(-1.0), 0.0);
  EXPECT_EQ(motion.displacement(0.5), 1.0);
  EXPECT_EQ(motion.displacement(1.0), 2.0);
  EXPECT_EQ(motion.displacement(2.0), 2.0 + 3.0);
  EXPECT_EQ(motion.displacement(3.0), 2.0 + 8.0);
  EXPECT_EQ(motion.displacement(3.5), 10.0 + 0.5 * 0.5 * (6.0 + 2.5));
  EXPECT_EQ(motion.displacement(4.0), 12.5);
  EXPECT_EQ(motion.displacement(6.0), 10.5);
  // A point at the very start is no special case.
  const Motion from_zero = by_table(Motion::Quantity::velocity, {{0.0, 0.0}, {2.0, 4.0}});
  EXPECT_EQ(from_zero.displacement(1.0), 1.0);
  EXPECT_EQ(from_zero.displacement(2.0), 4.0);
}

} // namespace towform
