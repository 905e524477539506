#include "element/membrane.hpp"
#include "element/sheet.hpp"
#include "element/stable_step.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace towform {
namespace {

using test::degree;
const YarnLaw glass{1e6, 0.1};

Vec3 turned(const Vec3& p)
{
  // 40 degrees about (1, 2, 2)/3, by Rodrigues.
  const Vec3 k{1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
  const double c = std::cos(40.0 * degree), s = std::sin(40.0 * degree);
  return c * p + s * cross(k, p) + ((1.0 - c) * dot(k, p)) * k;
}

double largest(const std::vector<Vec3>& forces)
{
  double most = 0.0;
  for (const Vec3& f : forces) most = std::max(most, norm(f));
  return most;
}

TEST(Yarn, TensionIsTheDerivativeOfItsEnergy)
{
  for (const double strain : {-0.05, -1e-4, -1e-5, 0.0, 3e-5, 2e-4, 0.03}) {
    const double d = 1e-7;
    EXPECT_NEAR(glass.tension(strain), (glass.energy(strain + d) - glass.energy(strain - d)) / (2.0 * d),
                1e-6 * glass.stiffness * d + 1e-6 * std::abs(glass.tension(strain)) + 1e-4);
  }
  EXPECT_EQ(glass.tension(0.0), 0.0);
  EXPECT_NEAR(glass.tension(0.02), 0.02e6, 0.01 * 0.02e6);
  EXPECT_NEAR(glass.tension(-0.02), -0.002e6, 0.03 * 0.002e6);
}

TEST(Membrane, RigidMotionMakesNoForce)
{
  const Blank blank = test::blank(Pattern::unstructured, 30.0 * degree, 0.0);
  const Membrane membrane(blank, glass, test::law(LawKind::viscous));
  std::vector<Vec3> moved;
  for (const Vec3& p : blank.mesh.points) moved.push_back(turned(p) + Vec3{0.3, -0.2, 0.5});
  const State s = test::loaded(membrane, moved);
  // Strains are differences of order 1e-16 times 1e6 N/m over edges of 1e-2 m.
  EXPECT_LT(largest(s.force), 1e-9);
  for (const double angle : s.shear_angle) EXPECT_NEAR(angle, 0.0, 1e-13);
}

TEST(Membrane, UniformDeformationPassesThePatchTest)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured}) {
    const Blank blank =
        test::blank(pattern, 25.0 * degree, pattern == Pattern::unstructured ? 0.0 : 20.0 * degree);
    const Membrane membrane(blank, glass, test::law(LawKind::elastic));
    const auto map = [](const Vec3& p) {
      return Vec3{1.01 * p.x + 0.2 * p.y, 0.15 * p.x + 1.02 * p.y, 0.05 * p.x};
    };
    std::vector<Vec3> moved;
    for (const Vec3& p : blank.mesh.points) moved.push_back(map(p));
    const State s = test::loaded(membrane, moved);

    // P of the page's formula, from the map alone.
    const Vec3 a1 = map(blank.warp), a2 = map(blank.weft);
    const double l1 = norm(a1), l2 = norm(a2);
    const Vec3 f1 = (1.0 / l1) * a1, f2 = (1.0 / l2) * a2;
    const double sine = dot(f1, f2), n = s.shear_force[0];
    EXPECT_NEAR(s.shear_angle[0], std::asin(sine), 1e-14);
    const Vec3 p1 = glass.tension(l1 - 1.0) * f1 + (n / l1) * (f2 - sine * f1);
    const Vec3 p2 = glass.tension(l2 - 1.0) * f2 + (n / l2) * (f1 - sine * f2);

    // What the sheet pulls on its edge x = 0.05 is -P e_x times its length; inside, nodes are in balance.
    Vec3 edge;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const Vec3& x = blank.mesh.points[i];
      if (x.x > 0.05 - 1e-9) edge += s.force[i];
      if (std::abs(x.x) < 0.05 - 1e-9 && std::abs(x.y) < 0.04 - 1e-9) {
        EXPECT_LT(norm(s.force[i]), 1e-10);
      }
    }
    Vec3 expected = -0.08 * (blank.warp.x * p1 + blank.weft.x * p2);
    // The edge's end nodes carry half of the neighbouring edges too.
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const Vec3& x = blank.mesh.points[i];
      if (x.x < 0.05 - 1e-9 || std::abs(std::abs(x.y) - 0.04) > 1e-9) continue;
      double half = 1.0; // half the distance to the next node on the side y = +-0.04
      for (const Vec3& other : blank.mesh.points)
        if (std::abs(other.y - x.y) < 1e-9 && other.x < x.x - 1e-9)
          half = std::min(half, 0.5 * (x.x - other.x));
      expected -= std::copysign(half, x.y) * (blank.warp.y * p1 + blank.weft.y * p2);
    }
    EXPECT_LT(norm(edge - expected), 1e-9 * norm(expected)) << static_cast<int>(pattern);
  }
}

TEST(Membrane, ForcesAreTheDerivativeOfTheYarnEnergy)
{
  const Blank blank = test::blank(Pattern::cross, 45.0 * degree, 0.0, 24);
  // A matrix so thin that only yarns remain.
  Membrane membrane(blank, glass, test::law(LawKind::elastic, test::newtonian_twill(1e-12)));
  membrane.own_stiffness = 5e4;
  const std::vector<Vec3> base = test::perturbed(blank.mesh.points, 2e-4);
  const State s = test::loaded(membrane, base);
  const auto energy = [&](const std::vector<Vec3>& x) {
    State moved = test::at_rest(membrane, x);
    membrane_forces(membrane, moved, 1e-5);
    return membrane.yarn_energy(moved);
  };
  const double scale = largest(s.force), step = 1e-8;
  for (std::size_t i = 0; i < base.size(); i += 3) {
    const Vec3 gradient = test::gradient(energy, base, i, step);
    EXPECT_LT(norm(s.force[i] + gradient), 1e-5 * scale);
  }
}

TEST(Membrane, ForcesBalanceAndTurnWithTheSheet)
{
  Blank blank = test::blank(Pattern::unstructured, 10.0 * degree, 0.0);
  blank.weft = {std::cos(75.0 * degree), std::sin(75.0 * degree), 0.0}; // yarns not square in the reference
  const Membrane membrane(blank, glass, test::law(LawKind::viscous));
  const std::vector<Vec3> moved = test::perturbed(blank.mesh.points, 1e-3);
  const State s = test::loaded(membrane, moved);
  Vec3 sum, moment;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    sum += s.force[i];
    moment += cross(moved[i], s.force[i]);
  }
  const double scale = largest(s.force);
  EXPECT_LT(norm(sum), 1e-12 * scale);
  EXPECT_LT(norm(moment), 1e-13 * scale);

  std::vector<Vec3> rotated;
  for (const Vec3& p : moved) rotated.push_back(turned(p));
  const State r = test::loaded(membrane, rotated);
  for (std::size_t i = 0; i < moved.size(); ++i)
    EXPECT_LT(norm(r.force[i] - turned(s.force[i])), 1e-9 * scale);
}

TEST(Membrane, ShearWorkIsTheWorkOfItsForces)
{
  // The powers of corner forces over a path add up to yarn energy, shear work and yarn damping.
  const Blank blank = test::blank(Pattern::diagonal, 0.0, 0.0, 40);
  Membrane membrane(blank, glass, test::law(LawKind::viscous));
  membrane.damping_time = 2e-7;
  State s = test::at_rest(membrane, blank.mesh.points);
  const std::vector<Vec3> target = test::perturbed(blank.mesh.points, 8e-4);
  const int steps = 4000;
  double work = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const std::vector<Vec3> before = s.position, force_before = s.force;
    for (std::size_t i = 0; i < target.size(); ++i)
      s.position[i] =
          blank.mesh.points[i] + (static_cast<double>(k) / steps) * (target[i] - blank.mesh.points[i]);
    membrane_forces(membrane, s, 1e-6);
    assemble(membrane.blocks, s.block_force, s.force);
    for (std::size_t i = 0; i < target.size(); ++i)
      work -= 0.5 * dot(force_before[i] + s.force[i], s.position[i] - before[i]);
  }
  double stored = membrane.yarn_energy(s);
  for (const double w : s.shear_work) stored += w;
  for (const double w : s.yarn_damping) stored += w;
  EXPECT_NEAR(work, stored, 2e-3 * work);
  EXPECT_GT(work, 0.0);
}

TEST(Membrane, MirrorsThatExchangeYarnsSeeBothFamilies)
{
  // A quarter of a +-45 degree sheet under a field symmetric about both planes: forces off the planes equal
  // those of the whole sheet.
  BlankParameters p;
  p.size = {0.08, 0.08};
  p.elements = 128;
  p.fibre_angle = 45.0 * degree;
  p.mesh_angle = -45.0 * degree;
  p.thickness = 1e-3;
  const Blank whole = make_blank(p);
  p.symmetry = Symmetry::quarter;
  const Blank quarter = make_blank(p);
  const auto forces = [](const Blank& blank) {
    const Membrane membrane(blank, glass, test::law(LawKind::viscous));
    std::vector<Vec3> x = blank.mesh.points;
    for (Vec3& q : x) q = {q.x * (1.0 + 2.0 * q.y * q.y), q.y * (1.0 - 5.0 * q.x * q.x), 3.0 * q.x * q.x};
    return test::loaded(membrane, x).force;
  };
  const std::vector<Vec3> of_whole = forces(whole), of_quarter = forces(quarter);
  const double scale = largest(of_whole);
  int compared = 0;
  for (std::size_t i = 0; i < of_quarter.size(); ++i) {
    const Vec3& at = quarter.mesh.points[i];
    if (at.x == 0.0 || at.y == 0.0) continue;
    for (std::size_t j = 0; j < of_whole.size(); ++j)
      if (whole.mesh.points[j] == at) {
        EXPECT_LT(norm(of_whole[j] - of_quarter[i]), 1e-10 * scale);
        ++compared;
      }
  }
  EXPECT_GT(compared, 10);
}

/// The largest frequency of the linearised sheet, by power iteration on finite differences of its forces.
double true_frequency(const Membrane& membrane, const std::vector<Vec3>& base,
                      const std::vector<double>& mass)
{
  const State rest = test::loaded(membrane, base);
  std::vector<Vec3> mode = test::perturbed(std::vector<Vec3>(base.size()), 1.0, 7);
  double omega_squared = 0.0;
  for (int k = 0; k < 400; ++k) {
    double size = 0.0;
    for (const Vec3& m : mode) size += norm_squared(m);
    State s = rest;
    const double step = 1e-7 / std::sqrt(size);
    for (std::size_t i = 0; i < base.size(); ++i) s.position[i] += step * mode[i];
    membrane_forces(membrane, s, 1e-12); // so short that the viscous law is its spring
    assemble(membrane.blocks, s.block_force, s.force);
    double next = 0.0;
    for (std::size_t i = 0; i < base.size(); ++i) {
      mode[i] = (1.0 / (mass[i] * step)) * (rest.force[i] - s.force[i]);
      next += norm_squared(mode[i]);
    }
    omega_squared = std::sqrt(next / size);
    for (Vec3& m : mode) m *= 1.0 / std::sqrt(next);
  }
  return std::sqrt(omega_squared);
}

std::vector<double> in_thirds(const Membrane& membrane, const std::vector<double>& element_mass)
{
  std::vector<double> mass(membrane.node_area.size(), 0.0);
  for (std::size_t e = 0; e < element_mass.size(); ++e)
    for (const int n : membrane.triangles[e]) mass[n] += element_mass[e] / 3.0;
  return mass;
}

TEST(StepBound, IsBelowTheTrueLimitAndNotFarBelow)
{
  const YarnLaw taut{1e6, 1.0};
  for (const double shear : {0.0, 0.7})
    for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured}) {
      const Blank blank = test::blank(pattern, 0.0, 0.0, 200);
      Membrane membrane(blank, taut, test::law(LawKind::viscous));
      std::vector<double> element_mass;
      for (const double area : membrane.areas()) element_mass.push_back(1.48 * area);
      const std::vector<double> mass = in_thirds(membrane, element_mass);
      std::vector<Vec3> x = blank.mesh.points;
      for (Vec3& p : x) p = {p.x + std::sin(shear) * p.y, std::cos(shear) * p.y, 0.0};
      const State s = test::loaded(membrane, x);
      const double modulus = std::get<ViscousLaw>(membrane.law).modulus;
      const double limit = 2.0 / true_frequency(membrane, x, mass);
      const double bound = StepBound(membrane, {element_mass, mass}, modulus).at(s).step;
      EXPECT_LE(bound, 1.001 * limit) << "shear " << shear << ", pattern " << static_cast<int>(pattern);
      EXPECT_GE(bound, 0.45 * limit) << "shear " << shear << ", pattern " << static_cast<int>(pattern);
      RecordProperty("margin", std::to_string(limit / bound));
      std::printf("shear %.1f pattern %d: bound %.3g, limit %.3g s, ratio %.3f\n", shear,
                  static_cast<int>(pattern), bound, limit, limit / bound);

      const auto factors = StepBound(membrane, {element_mass, mass}, modulus).mass_factors(s, 2.0 * bound);
      std::vector<double> heavier = element_mass;
      for (std::size_t e = 0; e < heavier.size(); ++e) heavier[e] *= factors[e];
      const std::vector<double> heavier_nodes = in_thirds(membrane, heavier);
      EXPECT_GE(StepBound(membrane, {heavier, heavier_nodes}, modulus).at(s).step, 1.8 * bound);
    }
}

} // namespace
} // namespace towform
