#include "case/float_traps.hpp"
#include "solver/kick_and_drift.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace towform {
namespace {

struct Nodes {
  std::vector<Vec3> position, velocity, force;
  std::vector<double> mass;

  explicit Nodes(std::size_t count)
  {
    for (std::size_t n = 0; n < count; ++n) {
      const double x = 1.0 + 0.37 * static_cast<double>(n);
      position.push_back({x, -x, 0.1 * x});
      velocity.push_back({0.2 * x, std::sin(x), -x});
      force.push_back({std::cos(x), 3.0, -0.5 * x});
      mass.push_back(0.01 * x);
    }
  }
  double move(double kick, double dt) { return kick_and_drift({position, velocity, force, mass}, kick, dt); }
};

TEST(KickAndDrift, MovesEveryNodeByItsOwnForceWhateverTheirNumber)
{
  constexpr double kick = 2e-3, dt = 3e-3;
  for (std::size_t count = 0; count < 20; ++count) { // whole vectors and rests
    Nodes nodes(count);
    const Nodes before = nodes;
    const double largest = nodes.move(kick, dt);
    double expected = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      const Vec3 velocity = before.velocity[n] + (kick / before.mass[n]) * before.force[n];
      EXPECT_EQ(nodes.velocity[n], velocity);
      EXPECT_EQ(nodes.position[n], before.position[n] + dt * velocity);
      expected = std::max(expected, norm_squared(velocity));
    }
    EXPECT_EQ(largest, expected);
  }
}

TEST(KickAndDrift, SaysSoOnceASpeedIsNotFinite)
{
  const UntrappedFloats judging;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {nan, -nan, HUGE_VAL, -HUGE_VAL, 1e200}) // whose square overflows
    for (const std::size_t node : {0, 3, 16}) {
      Nodes nodes(17);
      nodes.velocity[node].y = wrong;
      EXPECT_EQ(nodes.move(1e-3, 1e-3), HUGE_VAL);
    }
}

} // namespace
} // namespace towform
