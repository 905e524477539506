#include "element/membrane.hpp"
#include "element/sheet.hpp"
#include "element/stable_step.hpp"
#include <gtest/gtest.h>

/// Yarns that are not square to one another in the reference.
namespace towform {
namespace {

using test::degree;
const YarnLaw glass{1e6, 0.1};

/// Warp at 20 degrees, weft so much further round.
Blank oblique(double between, Pattern pattern = Pattern::unstructured)
{
  Blank blank = test::blank(pattern, 0.0, 0.0);
  blank.warp = {std::cos(20.0 * degree), std::sin(20.0 * degree), 0.0};
  blank.weft = {std::cos(20.0 * degree + between), std::sin(20.0 * degree + between), 0.0};
  return blank;
}

const std::vector<double> angles_between{55.0 * degree, 120.0 * degree, -70.0 * degree};

std::vector<Vec3> mapped(const std::vector<Vec3>& points, const std::array<Vec3, 2>& columns)
{
  std::vector<Vec3> moved;
  for (const Vec3& p : points) moved.push_back(p.x * columns[0] + p.y * columns[1] + Vec3{0.1, 0.2, -0.3});
  return moved;
}

double largest(const std::vector<Vec3>& forces)
{
  double most = 0.0;
  for (const Vec3& f : forces) most = std::max(most, norm(f));
  return most;
}

TEST(ObliqueYarns, RigidMotionMakesNoForceAndNoShear)
{
  const double c = std::cos(50.0 * degree), s = std::sin(50.0 * degree);
  for (const double between : angles_between)
    for (const LawKind kind : {LawKind::viscous, LawKind::elastic}) {
      const Blank blank = oblique(between);
      const Membrane membrane(blank, glass, test::law(kind));
      const State state =
          test::loaded(membrane, mapped(blank.mesh.points, {Vec3{c, 0.0, s}, Vec3{0.0, 1.0, 0.0}}));
      EXPECT_LT(largest(state.force), 1e-8); // strains of 1e-16 times 1e6 N/m, and a shear law steep at zero
      for (const double angle : state.shear_angle) EXPECT_NEAR(angle, 0.0, 1e-13);
    }
}

/// Nodal forces of a uniform deformation: inside none, on the edges those of the one stress P.
TEST(ObliqueYarns, UniformDeformationPassesThePatchTest)
{
  const std::array<Vec3, 2> columns{Vec3{1.01, 0.15, 0.05}, Vec3{0.2, 1.02, 0.0}};
  for (const double between : angles_between)
    for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured}) {
      const Blank blank = oblique(between, pattern);
      const Membrane membrane(blank, glass, test::law(LawKind::elastic));
      const State s = test::loaded(membrane, mapped(blank.mesh.points, columns));
      const auto map = [&](const Vec3& v) { return v.x * columns[0] + v.y * columns[1]; };
      const Vec3 a1 = map(blank.warp), a2 = map(blank.weft);
      const double l1 = norm(a1), l2 = norm(a2);
      const Vec3 f1 = (1.0 / l1) * a1, f2 = (1.0 / l2) * a2;
      const double sine = dot(f1, f2), n = s.shear_force[0];
      // Shear is counted from the angle that the yarns have in the reference.
      EXPECT_NEAR(s.shear_angle[0], std::asin(sine) - std::asin(dot(blank.warp, blank.weft)), 1e-14);
      const Vec3 p1 = glass.tension(l1 - 1.0) * f1 + (n / l1) * (f2 - sine * f1);
      const Vec3 p2 = glass.tension(l2 - 1.0) * f2 + (n / l2) * (f1 - sine * f2);
      const double scale = norm(p1) + norm(p2);

      // Virtual work: sum f_i . u(x_i) = -area P : grad u for every linear u, and no node inside feels a
      // force.
      const double area = 0.1 * 0.08;
      for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        for (const bool by_x : {true, false}) {
          double work = 0.0;
          for (std::size_t i = 0; i < s.force.size(); ++i)
            work += dot(s.force[i], direction) * (by_x ? blank.mesh.points[i].x : blank.mesh.points[i].y);
          const double p = dot(direction, p1) * (by_x ? blank.warp.x : blank.warp.y) +
                           dot(direction, p2) * (by_x ? blank.weft.x : blank.weft.y);
          EXPECT_NEAR(work, -area * p, 1e-11 * area * scale);
        }
      for (std::size_t i = 0; i < s.force.size(); ++i) {
        const Vec3& x = blank.mesh.points[i];
        if (std::abs(x.x) < 0.05 - 1e-9 && std::abs(x.y) < 0.04 - 1e-9) {
          EXPECT_LT(norm(s.force[i]), 1e-13 * scale);
        }
      }
    }
}

TEST(ObliqueYarns, ForcesAreTheDerivativeOfTheEnergy)
{
  // The elastic law stores W(s), N = dW/ds: summed over small steps of the path it is the work that the shear
  // forces do, and the forces at its end are its gradient.
  for (const double between : angles_between) {
    const Blank blank = oblique(between, Pattern::cross);
    const Membrane membrane(blank, glass, test::law(LawKind::elastic));
    const ElasticLaw law = std::get<ElasticLaw>(membrane.law);
    const std::vector<Vec3> base = test::perturbed(blank.mesh.points, 8e-4);
    const State state = test::loaded(membrane, base);
    const double reference = std::asin(membrane.reference_sine);
    const auto shear_energy =
        [&](double angle) { // Simpson's rule on N cos(theta) dtheta, smooth on either side of
          double sum = 0.0; // the joint at zero: half-degree pieces
          const int pieces = 2 * static_cast<int>(std::ceil(std::abs(angle) / ElasticLaw::joint));
          ShearPoint p;
          const auto at = [&](double g) {
            law.update(p, g, 1.0);
            return p.force * std::cos(g + reference);
          };
          const double joint = std::copysign(std::min(std::abs(angle), ElasticLaw::joint), angle);
          for (const auto& [from, to] : {std::pair{0.0, joint}, std::pair{joint, angle}})
            for (int k = 0; k < pieces; ++k) {
              const double step = (to - from) / pieces, a = from + k * step;
              sum += step / 6.0 * (at(a) + 4.0 * at(a + 0.5 * step) + at(a + step));
            }
          return sum;
        };
    const std::vector<double> area = membrane.areas();
    const auto energy = [&](const std::vector<Vec3>& x) {
      State moved = test::at_rest(membrane, x);
      membrane_forces(membrane, moved, 1e-5);
      double sum = membrane.yarn_energy(moved);
      for (std::size_t e = 0; e < moved.shear_angle.size(); ++e)
        sum += area[e] * shear_energy(moved.shear_angle[e]);
      return sum;
    };
    const double scale = largest(state.force), step = 1e-8;
    for (std::size_t i = 0; i < base.size(); i += 5) {
      const Vec3 gradient = test::gradient(energy, base, i, step);
      EXPECT_LT(norm(state.force[i] + gradient), 1e-5 * scale)
          << between / degree; // of the finite difference
    }
  }
}

TEST(ObliqueYarns, StepBoundHolds)
{
  // Power iteration on finite differences of the forces, as for square yarns.
  const YarnLaw taut{1e6, 1.0};
  for (const double between : angles_between) {
    const Blank blank = oblique(between);
    const Membrane membrane(blank, taut, test::law(LawKind::viscous));
    std::vector<double> element_mass, mass(blank.mesh.points.size(), 0.0);
    const std::vector<double> area = membrane.areas();
    for (std::size_t e = 0; e < area.size(); ++e) {
      element_mass.push_back(1.48 * area[e]);
      for (const int n : membrane.triangles[e]) mass[n] += element_mass[e] / 3.0;
    }
    const State rest = test::loaded(membrane, blank.mesh.points);
    std::vector<Vec3> mode = test::perturbed(std::vector<Vec3>(mass.size()), 1.0, 7);
    double omega_squared = 0.0;
    for (int k = 0; k < 400; ++k) {
      double size = 0.0, next = 0.0;
      for (const Vec3& m : mode) size += norm_squared(m);
      State s = rest;
      const double step = 1e-7 / std::sqrt(size);
      for (std::size_t i = 0; i < mass.size(); ++i) s.position[i] += step * mode[i];
      membrane_forces(membrane, s, 1e-12);
      assemble(membrane.blocks, s.block_force, s.force);
      for (std::size_t i = 0; i < mass.size(); ++i) {
        mode[i] = (1.0 / (mass[i] * step)) * (rest.force[i] - s.force[i]);
        next += norm_squared(mode[i]);
      }
      omega_squared = std::sqrt(next / size);
      for (Vec3& m : mode) m *= 1.0 / std::sqrt(next);
    }
    const double limit = 2.0 / std::sqrt(omega_squared);
    const double bound =
        StepBound(membrane, {element_mass, mass}, std::get<ViscousLaw>(membrane.law).modulus).at(rest).step;
    EXPECT_LE(bound, 1.001 * limit) << between / degree;
    EXPECT_GE(bound, 0.45 * limit) << between / degree;
  }
}

} // namespace
} // namespace towform
