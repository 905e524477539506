#include "element/held_bending.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

/// How far a single wave swings in later holds, over its first swings.
double swing(double omega_dt, double damping_steps, int interval)
{
  double place = 1.0, velocity = 0.0, before = 1.0, early = 0.0, late = 0.0;
  constexpr int holds = 4000, some = 400;
  for (int hold = 0; hold < holds; ++hold) {
    const double force =
        -omega_dt * omega_dt * (place + (held_ahead(interval) + damping_steps / interval) * (place - before));
    before = place;
    for (int step = 0; step < interval; ++step) place += velocity += force;
    if (hold < some) early = std::max(early, std::abs(place));
    if (hold >= holds - some) late = std::max(late, std::abs(place));
  }
  return late / early;
}

} // namespace

TEST(HeldBending, AWaveOfForcesComputedAtEveryStepNeitherGrowsNorDies)
{
  EXPECT_NEAR(hold_growth(0.3, 0.0, 1), 0.0, 1e-12);
  EXPECT_GT(hold_growth(2.01, 0.0, 1), 0.1); // the limit of central differences
}

TEST(HeldBending, WavesGrowAsIsForetold)
{
  for (const int interval : {2, 5, 8})
    for (const double damping : {0.0, 0.3})
      for (const double turned : {0.3, 0.5}) {
        const double growth = hold_growth(turned / interval, damping, interval);
        EXPECT_NEAR(std::log(swing(turned / interval, damping, interval)), 3600 * std::log1p(growth),
                    0.02 * 3600 * std::abs(growth) + 0.1)
            << interval << ' ' << damping << ' ' << turned;
      }
}

TEST(HeldBending, IsHeldAsLongAsNoWaveGrows)
{
  EXPECT_EQ(longest_hold(0.01, 10.0, 8), 8);
  EXPECT_EQ(longest_hold(0.3, 0.0, 8), 1); // nothing takes away what held forces feed
  int last = 8;
  for (double omega_dt = 0.02; omega_dt < 0.6; omega_dt += 0.02) {
    const double damping = 0.1 / omega_dt; // 5 % of critical
    const int hold = longest_hold(omega_dt, damping, 8);
    EXPECT_LE(hold, last) << omega_dt;
    EXPECT_LE(swing(omega_dt, damping, hold), 1.0) << omega_dt;
    last = hold;
  }
  EXPECT_EQ(last, 1);
}

} // namespace towform
