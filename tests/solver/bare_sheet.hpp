#pragma once
#include "element/stable_step.hpp"
#include "material/gf_pp.hpp"
#include "solver/energy.hpp"
#include "solver/model.hpp"
#include "solver/step.hpp"
#include <algorithm>
#include <cmath>
#include <random>

namespace towform::test {

/// A sheet without tools, 100 x 80 mm: yarns as stiff pressed as pulled, no damping, a matrix that flows
/// almost freely. What is left is an elastic body whose answers are known.
inline Case bare_sheet()
{
  Case c;
  c.blank.size = {0.1, 0.08};
  c.blank.elements = 160;
  c.blank.thickness = 1e-3;
  c.material.constituents = newtonian_twill(1e-3);
  c.material.temperature = 463.15;
  c.material.law = LawKind::elastic;
  c.material.curve_rate_min = 1.0;
  c.material.curve_rate_max = 20.0;
  c.material.elastic_rate = 10.0;
  c.material.fibre_modulus = 1e9;
  c.material.strip_stiffness = 1e9; // with hardly any shear force to hold triangles to their strips: the most
  c.material.compression_factor = 1.0;
  c.material.yarn_damping = 0.0;
  c.material.relaxation_ratio = 0.1;
  c.time.end = 1.0;
  return c;
}

/// Speeds of up to `most` in every direction.
inline void shake(System& s, double most, unsigned seed = 1)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> speed(-most, most);
  for (Vec3& v : s.sheet.velocity) v = {speed(generator), speed(generator), speed(generator)};
}

inline Vec3 momentum(const Model& model, const System& s)
{
  Vec3 sum;
  for (std::size_t n = 0; n < model.mass.size(); ++n) sum += model.mass[n] * s.sheet.velocity[n];
  return sum;
}

inline double moving_energy(const Model& model, const System& s)
{
  const Energies e = energy_account(model, s);
  return e.kinetic + e.internal();
}

inline void step_on(const Model& model, System& s, double dt, int steps)
{
  Phases untimed;
  for (int i = 0; i < steps; ++i) step(model, s, dt, untimed);
}

/// Largest energy over the first, from speeds of up to `most`, during `rounds` times 20 steps of dt; infinite once it has
/// run away.
inline double growth(const Model& model, double dt, double most, int rounds)
{
  System s = start(model);
  shake(s, most);
  step_on(model, s, dt, 1);
  const double first = moving_energy(model, s);
  double largest = first;
  for (int i = 0; i < rounds; ++i) {
    step_on(model, s, dt, 20);
    const double now = moving_energy(model, s);
    if (!(now < 1e6 * first)) return HUGE_VAL;
    largest = std::max(largest, now);
  }
  return largest / first;
}

} // namespace towform::test
