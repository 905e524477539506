#include "elastica.hpp"
#include "parallel/parallel.hpp"
#include "solver/bare_sheet.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

using Edge = BoundaryParameters::Edge;
constexpr double stiffness = 1e-3, weight = 1.48 * 9.81; // B [N m], w [N/m^2]

/// A strip along x, held level at its left end, under its own weight. The yarns are soft enough for a long
/// step and still stretch by less than 1e-4; damped so that the slowest swing dies in some tenths of a
/// second.
Case strip(double length, double width, double edge)
{
  Case c = test::bare_sheet();
  c.blank.size = {length, width};
  c.blank.elements.reset();
  c.blank.edge = edge;
  c.material.fibre_modulus = 1e7;
  c.material.yarn_damping = 0.05;
  c.material.shear_tangent = {1e5}; // holds the strip straight in its plane
  c.material.bending_stiffness = Vec2{stiffness, stiffness};
  c.material.bending_damping = 0.05;
  c.load.gravity = {0.0, 0.0, -9.81};
  c.boundaries.push_back({"clamp", BoundaryParameters::Kind::grip, Edge::left, {}});
  return c;
}

/// Critical damping of the slowest swing of a cantilever [1/s].
double critical(double length) { return 2.0 * 3.516 * std::sqrt(stiffness / 1.48) / (length * length); }

/// Lets a strip come to rest.
System settled(const Case& c, const Model& model, double seconds)
{
  set_threads(1); // a few hundred elements
  System s = start(model);
  Phases untimed;
  const auto steps = static_cast<int>(seconds / (0.9 * model.first_step));
  for (int i = 0; i < steps; ++i) step(model, s, 0.9 * model.first_step, untimed);
  EXPECT_LT(energy_account(model, s).kinetic, 1e-6 * energy_account(model, s).external) << c.title;
  return s;
}

/// Largest distance of any node from the elastica, over the length.
double distance_from_elastica(Case c)
{
  const double length = c.blank.size.x;
  c.time.mass_damping = critical(length);
  const Model model = build_model(c);
  const System s = settled(c, model, 30.0 / c.time.mass_damping);
  const test::HeavyElastica exact(length, weight / stiffness);
  double worst = 0.0;
  for (std::size_t n = 0; n < model.mass.size(); ++n) {
    const Vec3 &x = s.sheet.position[n], &flat = model.blank.mesh.points[n];
    const auto [along, drop] = exact.at(flat.x + 0.5 * length);
    worst = std::max(worst, std::hypot(x.x + 0.5 * length - along, x.z + drop));
  }
  return worst / length;
}

TEST(Cantilever, HangsAsTheElasticaDoesOnEveryMesh)
{
  // The tip drops by 0.57 of the length. With twelve elements along it (curvature times edge)^2 is 0.006.
  struct Mesh {
    Pattern pattern;
    double angle;
  };
  for (const Mesh& mesh : {Mesh{Pattern::diagonal, 0.0}, Mesh{Pattern::cross, 0.0},
                           Mesh{Pattern::diagonal, 30.0}, Mesh{Pattern::unstructured, 0.0}}) {
    Case c = strip(0.06, 0.02, 0.005);
    c.blank.pattern = mesh.pattern;
    c.blank.mesh_angle = mesh.angle * M_PI / 180.0;
    const double distance = distance_from_elastica(c);
    std::printf("pattern %d, mesh at %.0f degrees: %.2e of the length from the elastica\n",
                static_cast<int>(mesh.pattern), mesh.angle, distance);
    EXPECT_LT(distance, 1e-2);
  }
}

TEST(Cantilever, ConvergesToTheElastica)
{
  std::vector<double> errors;
  for (const double edge : {0.01, 0.005, 0.0025})
    errors.push_back(distance_from_elastica(strip(0.06, 0.02, edge)));
  std::printf("edges of 10, 5, 2.5 mm: %.2e %.2e %.2e of the length\n", errors[0], errors[1], errors[2]);
  for (const int i : {0, 1}) EXPECT_GT(std::log2(errors[i] / errors[i + 1]), 1.7); // second order, or better
  EXPECT_LT(errors[2], 1e-3);
}

TEST(Cantilever, HasPeircesOverhang)
{
  // A strip that overhangs by twice its bending length (B/w)^(1/3) has its tip 41.5 degrees down, seen from
  // the edge (Peirce 1930). His formula for any angle a, L (cos(a/2) / (8 tan a))^(1/3), is an approximation:
  // at this angle it is 1.9 % too long for the exact curve.
  const double bending_length = std::cbrt(stiffness / weight);
  Case c = strip(2.0 * bending_length, 0.02, 0.004);
  const double length = c.blank.size.x;
  c.time.mass_damping = critical(length);
  const Model model = build_model(c);
  const System s = settled(c, model, 30.0 / c.time.mass_damping);
  const auto [exact_x, exact_drop] = test::HeavyElastica(length, weight / stiffness).at(length);
  const double exact = std::atan2(exact_drop, exact_x);
  double x = 0.0, drop = 0.0;
  for (std::size_t n = 0; n < model.mass.size(); ++n)
    if (model.blank.mesh.points[n].x > 0.5 * length - 1e-9) {
      x += s.sheet.position[n].x + 0.5 * length;
      drop -= s.sheet.position[n].z;
    }
  const double angle = std::atan2(drop, x);
  const double by_formula = length * std::cbrt(std::cos(0.5 * angle) / (8.0 * std::tan(angle)));
  std::printf("tip at %.2f degrees, exact %.2f; bending length %.3f mm, by Peirce's formula %.3f mm\n",
              angle * 180.0 / M_PI, exact * 180.0 / M_PI, 1e3 * bending_length, 1e3 * by_formula);
  EXPECT_NEAR(exact * 180.0 / M_PI, 41.5, 0.3);
  EXPECT_NEAR(angle, exact, 0.005 * exact);
  EXPECT_NEAR(by_formula, bending_length, 0.025 * bending_length);
}

/// Deepest sag over that of a beam, w L^4 / (`divisor` B), of a strip so lightly loaded that it is not
/// stretched, clamped at one end or both.
double sag_over_formula(double edge, bool both_ends, double divisor)
{
  constexpr double length = 0.06;
  Case c = strip(length, 0.02, edge);
  const double gravity = both_ends ? 1e-3 : 1e-2;
  c.load.gravity = {0.0, 0.0, -gravity};
  c.time.mass_damping = critical(length) * (both_ends ? 22.37 / 3.516 : 1.0);
  if (both_ends) c.boundaries.push_back({"other", BoundaryParameters::Kind::grip, Edge::right, {}});
  const Model model = build_model(c);
  const System s = settled(c, model, 30.0 / c.time.mass_damping);
  double lowest = 0.0;
  for (const Vec3& x : s.sheet.position) lowest = std::min(lowest, x.z);
  return -lowest / (1.48 * gravity * std::pow(length, 4) / (divisor * stiffness));
}

TEST(PlateStrip, SagsByTheFormulasOfBeams)
{
  for (const bool both_ends : {false, true}) {
    const double divisor = both_ends ? 384.0 : 8.0;
    const double coarse = sag_over_formula(0.005, both_ends, divisor),
                 fine = sag_over_formula(0.0025, both_ends, divisor);
    std::printf("clamped at %s: sag over the formula %.5f with edges of 5 mm, %.5f with 2.5 mm\n",
                both_ends ? "both ends" : "one end", coarse, fine);
    EXPECT_NEAR(fine, 1.0, both_ends ? 3e-2 : 5e-3);
    EXPECT_GT(std::log2((coarse - 1.0) / (fine - 1.0)), 1.7); // second order, or better
  }
}

} // namespace
} // namespace towform
