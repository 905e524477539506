#include "solver/kick_and_drift.hpp"
#include "parallel/vector_clones.hpp"
#include <bit>
#include <cmath>
#include <cstdint>

namespace towform {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

namespace {

/// The same with components in a row. Returns the bits of the largest square: those of numbers that are not negative stand in
/// their order, beyond them infinity and what is not a number.
TOWFORM_VECTOR_CLONES
std::int64_t move(double* position, double* velocity, const double* force, const double* mass, double kick, double dt,
                  std::ptrdiff_t count)
{
  double* __restrict x = position;
  double* __restrict v = velocity;
  const double* __restrict f = force;
  const double* __restrict m = mass;
  constexpr std::int64_t size = 0x7fffffffffffffff; // without the sign
  std::int64_t largest = 0;
  for (std::ptrdiff_t n = 0; n < count; ++n) {
    const double share = kick / m[n];
    const double vx = v[3 * n] + share * f[3 * n], vy = v[3 * n + 1] + share * f[3 * n + 1],
                 vz = v[3 * n + 2] + share * f[3 * n + 2];
    v[3 * n] = vx;
    v[3 * n + 1] = vy;
    v[3 * n + 2] = vz;
    x[3 * n] += dt * vx;
    x[3 * n + 1] += dt * vy;
    x[3 * n + 2] += dt * vz;
    const std::int64_t square = std::bit_cast<std::int64_t>(vx * vx + vy * vy + vz * vz) & size;
    largest = square > largest ? square : largest;
  }
  return largest;
}

} // namespace

double kick_and_drift(const MovingNodes& nodes, double kick, double dt)
{
  const std::int64_t bits = move(&nodes.position.data()->x, &nodes.velocity.data()->x, &nodes.force.data()->x, nodes.mass.data(),
                                 kick, dt, static_cast<std::ptrdiff_t>(nodes.mass.size()));
  const double largest = std::bit_cast<double>(bits);
  return std::isfinite(largest) ? largest : HUGE_VAL;
}

} // namespace towform
