#pragma once
#include "element/membrane.hpp"
#include "material/gf_pp.hpp"
#include "towform/blank.hpp"
#include <random>

namespace towform::test {

constexpr double degree = M_PI / 180.0;

inline Blank blank(Pattern pattern, double fibre_angle, double mesh_angle, int elements = 60)
{
  BlankParameters p;
  p.size = {0.1, 0.08};
  p.elements = elements;
  p.pattern = pattern;
  p.fibre_angle = fibre_angle;
  p.mesh_angle = mesh_angle;
  p.thickness = 1e-3;
  return make_blank(p);
}

inline FabricLaw law(LawKind kind, const Constituents& sheet = gf_pp_twill())
{
  MaterialParameters m;
  m.constituents = sheet;
  m.temperature = 463.15;
  m.law = kind;
  m.curve_rate_min = 1.0;
  m.curve_rate_max = 20.0;
  m.elastic_rate = 10.0;
  m.fibre_modulus = 1e9;
  m.relaxation_ratio = 0.1;
  return make_fabric_material(m, 1e-3).law;
}

inline State at_rest(const Membrane& membrane, const std::vector<Vec3>& position)
{
  State s;
  s.position = position;
  s.velocity.assign(position.size(), {});
  s.force.assign(position.size(), {});
  start(membrane, s);
  return s;
}

/// Forces at given positions, reached in one step from the stress-free reference.
inline State loaded(const Membrane& membrane, const std::vector<Vec3>& position)
{
  State s = at_rest(membrane, position);
  membrane_forces(membrane, s, 1e-5);
  assemble(membrane.blocks, s.block_force, s.force);
  return s;
}

inline std::vector<Vec3> perturbed(std::vector<Vec3> points, double amount, unsigned seed = 1)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> by(-amount, amount);
  for (Vec3& p : points) p += {by(generator), by(generator), by(generator)};
  return points;
}

/// Derivative of a function of all positions by one node's, by central differences.
template <class Energy>
Vec3 gradient(const Energy& energy, std::vector<Vec3> x, std::size_t node, double step)
{
  const auto slope = [&](double Vec3::*component) {
    const double here = x[node].*component;
    x[node].*component = here + step;
    const double up = energy(x);
    x[node].*component = here - step;
    const double down = energy(x);
    x[node].*component = here;
    return (up - down) / (2.0 * step);
  };
  return {slope(&Vec3::x), slope(&Vec3::y), slope(&Vec3::z)};
}

} // namespace towform::test
