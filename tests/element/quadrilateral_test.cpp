#include "element/quadrilateral.hpp"
#include "element/sheet.hpp"
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace towform {
namespace {

using test::degree;
using Vector = QuadrilateralMembrane::Vector;
using Matrix = QuadrilateralMembrane::Matrix;

BlankParameters rectangle(int elements, double fibre_angle = 0.0)
{
  BlankParameters p;
  p.size = {0.12, 0.08};
  p.elements = elements;
  p.fibre_angle = fibre_angle;
  p.mesh_angle = -fibre_angle;
  p.thickness = 1e-3;
  return p;
}

QuadrilateralMembrane sheet(const QuadrilateralGrid& grid, LawKind kind)
{
  return {grid, YarnLaw{1e6, 0.1}, test::law(kind)};
}

/// A homogeneous deformation of the plane, with a rotation in space.
std::vector<Vec3> deformed(const std::vector<Vec3>& points, const Eigen::Matrix3d& f)
{
  std::vector<Vec3> x;
  for (const Vec3& p : points) {
    const Eigen::Vector3d y = f * Eigen::Vector3d(p.x, p.y, p.z);
    x.push_back({y[0], y[1], y[2]});
  }
  return x;
}

Eigen::Matrix3d some_gradient()
{
  Eigen::Matrix3d f;
  f << 1.01, 0.31, 0.0, 0.12, 0.98, 0.0, 0.07, -0.04, 1.0;
  return f;
}

/// Histories, in front of and behind one update of every point.
struct Histories {
  std::vector<ShearPoint> before, after;
  std::vector<double> lost;
  double dt = 1e-2;

  explicit Histories(const QuadrilateralMembrane& m)
      : before(m.points.size()), after(m.points.size()), lost(m.points.size())
  {
  }
  QuadrilateralMembrane::Step step() { return {dt, before, after, lost}; }
};

std::vector<Vec3> assembled(const QuadrilateralMembrane& m, std::span<const Vec3> x, Histories& h)
{
  std::vector<Vec3> force(x.size());
  Vector f;
  for (std::size_t e = 0; e < m.elements.size(); ++e) {
    EXPECT_TRUE(m.response(e, x, h.step(), f, nullptr));
    for (int c = 0; c < 4; ++c) force[m.elements[e][c]] += {f[3 * c], f[3 * c + 1], f[3 * c + 2]};
  }
  return force;
}

TEST(QuadrilateralGrid, CoversTheBlankWithTheWantedElements)
{
  const QuadrilateralGrid g = make_quadrilateral_grid(rectangle(96));
  EXPECT_EQ(g.nx, 12);
  EXPECT_EQ(g.ny, 8);
  EXPECT_EQ(g.points.front(), (Vec3{-0.06, -0.04, 0.0}));
  EXPECT_EQ(g.points.back(), (Vec3{0.06, 0.04, 0.0}));
  const QuadrilateralMembrane m = sheet(g, LawKind::elastic);
  double area = 0.0;
  for (const QuadrilateralPoint& p : m.points) area += p.area;
  EXPECT_NEAR(area, 0.12 * 0.08, 1e-15);
  EXPECT_EQ(g.triangles().triangles.size(), 2 * 96U);
}

TEST(QuadrilateralGrid, RefusesLinesAcrossTheSides)
{
  BlankParameters p = rectangle(96);
  p.mesh_angle = 30.0 * degree;
  EXPECT_THROW(make_quadrilateral_grid(p), std::invalid_argument);
}

TEST(Quadrilateral, PatchOfDistortedElementsIsInEquilibriumUnderAUniformField)
{
  for (const LawKind kind : {LawKind::viscous, LawKind::incremental, LawKind::elastic}) {
    QuadrilateralGrid g = make_quadrilateral_grid(rectangle(24, 27.0 * degree));
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> by(-4e-3, 4e-3); // edges are 20 mm
    for (int j = 1; j < g.ny; ++j)
      for (int i = 1; i < g.nx; ++i) g.points[g.node(i, j)] += {by(generator), by(generator), 0.0};
    const QuadrilateralMembrane m = sheet(g, kind);
    Histories h(m);
    const auto x = deformed(g.points, some_gradient());
    const auto force = assembled(m, x, h);
    double largest = 0.0;
    for (const Vec3& f : force) largest = std::max(largest, norm(f));
    for (int j = 1; j < g.ny; ++j)
      for (int i = 1; i < g.nx; ++i) EXPECT_LT(norm(force[g.node(i, j)]), 1e-13 * largest);
    // and every point has the same state
    for (const ShearPoint& p : h.after) {
      EXPECT_NEAR(p.angle, h.after[0].angle, 1e-13);
      EXPECT_NEAR(p.force, h.after[0].force, 1e-10 * std::abs(h.after[0].force));
    }
  }
}

TEST(Quadrilateral, CarriesTheStressOfTheStructuralNet)
{
  // P f01 from the definition, for orthogonal yarns at 20 degrees of pure shear and no stretch.
  const QuadrilateralGrid g = make_quadrilateral_grid(rectangle(2)); // 2 x 1
  const QuadrilateralMembrane m = sheet(g, LawKind::elastic);
  Histories h(m);
  const double theta = 20.0 * degree;
  Eigen::Matrix3d f;
  f << 1.0, std::sin(theta), 0.0, 0.0, std::cos(theta), 0.0, 0.0, 0.0, 1.0;
  const auto force = assembled(m, deformed(g.points, f), h);
  const double n = h.after[0].force;
  EXPECT_NEAR(h.after[0].angle, theta, 1e-14);
  EXPECT_GT(n, 0.0);
  // On the side x = max: height times P f01 = N (f2 - s f1) = N cos(theta) y.
  Vec3 side;
  for (int j = 0; j <= g.ny; ++j) side += force[g.node(g.nx, j)];
  EXPECT_NEAR(side.x, 0.0, 1e-12 * n);
  EXPECT_NEAR(side.y, 0.08 * n * std::cos(theta), 1e-12 * n);
}

TEST(Quadrilateral, ForcesTurnWithTheBody)
{
  const QuadrilateralGrid g = make_quadrilateral_grid(rectangle(6));
  const QuadrilateralMembrane m = sheet(g, LawKind::viscous);
  Histories h(m), turned(m);
  const auto x = test::perturbed(g.points, 3e-3);
  const Eigen::Matrix3d r =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  const auto force = assembled(m, x, h), turned_force = assembled(m, deformed(x, r), turned);
  const auto expected = deformed(force, r);
  double largest = 0.0;
  for (const Vec3& f : force) largest = std::max(largest, norm(f));
  for (std::size_t n = 0; n < force.size(); ++n)
    EXPECT_LT(norm(turned_force[n] - expected[n]), 1e-11 * largest);
}

TEST(Quadrilateral, RigidMotionNeedsNoForce)
{
  const QuadrilateralGrid g = make_quadrilateral_grid(rectangle(6));
  for (const LawKind kind : {LawKind::viscous, LawKind::incremental, LawKind::elastic}) {
    const QuadrilateralMembrane m = sheet(g, kind);
    Histories h(m);
    const Eigen::Matrix3d r =
        Eigen::AngleAxisd(1.3, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
    for (const Vec3& f : assembled(m, deformed(g.points, r), h)) EXPECT_LT(norm(f), 1e-9); // of k = 1e6 N/m
  }
}

/// The tangent of a distorted, stretched and sheared element against central differences of its forces.
void expect_exact_tangent(LawKind kind, double dt, double fibre_angle)
{
  const QuadrilateralGrid g = make_quadrilateral_grid(rectangle(6, fibre_angle));
  QuadrilateralMembrane m = sheet(g, kind);
  if (auto* law = std::get_if<IncrementalLaw>(&m.law)) law->selection = CurveSelection::interpolate;
  Histories h(m);
  h.dt = dt;
  Vector f;
  // Some past, of the same sense and of the opposite one.
  for (std::size_t k = 0; k < h.before.size(); ++k) {
    const double sign = k % 3 == 0 ? -1.0 : 1.0;
    h.before[k] = {sign * (0.11 + 0.01 * static_cast<double>(k)), sign * 40.0, 2.0};
  }
  std::vector<Vec3> x = test::perturbed(deformed(g.points, some_gradient()), 1e-3);
  const std::size_t element = 2;
  Matrix exact, difference;
  ASSERT_TRUE(m.response(element, x, h.step(), f, &exact));
  EXPECT_LT((exact - exact.transpose()).norm(), 1e-13 * exact.norm());

  const double by =
      2e-8; // 1e-6 of the element: errors of order by^2 and epsilon/by are 1e-10 of the stiffness
  for (int column = 0; column < 12; ++column) {
    Vec3& moved = x[g.elements[element][column / 3]];
    double& component = column % 3 == 0 ? moved.x : column % 3 == 1 ? moved.y : moved.z;
    const double original = component;
    Vector ahead, behind;
    component = original + by;
    ASSERT_TRUE(m.response(element, x, h.step(), ahead, nullptr));
    component = original - by;
    ASSERT_TRUE(m.response(element, x, h.step(), behind, nullptr));
    component = original;
    difference.col(column) = (ahead - behind) / (2.0 * by);
  }
  EXPECT_LT((exact - difference).norm(), 1e-7 * exact.norm());
  // Yarns outweigh the shear law by orders of magnitude: look at it alone.
  m.yarn.stiffness = 0.0;
  Matrix shear_exact, shear_difference;
  ASSERT_TRUE(m.response(element, x, h.step(), f, &shear_exact));
  for (int column = 0; column < 12; ++column) {
    Vec3& moved = x[g.elements[element][column / 3]];
    double& component = column % 3 == 0 ? moved.x : column % 3 == 1 ? moved.y : moved.z;
    const double original = component;
    Vector ahead, behind;
    component = original + by;
    ASSERT_TRUE(m.response(element, x, h.step(), ahead, nullptr));
    component = original - by;
    ASSERT_TRUE(m.response(element, x, h.step(), behind, nullptr));
    component = original;
    shear_difference.col(column) = (ahead - behind) / (2.0 * by);
  }
  EXPECT_LT((shear_exact - shear_difference).norm(), 1e-6 * shear_exact.norm());
}

TEST(Quadrilateral, TangentIsExactForTheViscousLaw)
{
  for (const double dt : {1e-4, 1e-2, 1.0}) expect_exact_tangent(LawKind::viscous, dt, 0.0);
  expect_exact_tangent(LawKind::viscous, 1e-2, 31.0 * degree);
}

TEST(Quadrilateral, TangentIsExactForTheIncrementalLaw)
{
  for (const double dt : {1e-2, 5e-2, 10.0}) expect_exact_tangent(LawKind::incremental, dt, 0.0);
}

TEST(Quadrilateral, TangentIsExactForTheElasticLaw) { expect_exact_tangent(LawKind::elastic, 1e-2, 0.0); }

TEST(Quadrilateral, EveryStrainPatternMeetsStiffness)
{
  // Of twelve patterns of a flat element, six are rigid or out of plane (three rigid in plane, and z of four
  // corners): the rest must be stiff, hourglasses too.
  const QuadrilateralGrid g = make_quadrilateral_grid(rectangle(2));
  const QuadrilateralMembrane m = sheet(g, LawKind::elastic);
  Histories h(m);
  Vector f;
  Matrix k;
  ASSERT_TRUE(m.response(0, g.points, h.step(), f, &k));
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Matrix>(k).eigenvalues();
  EXPECT_LT(std::abs(values[6]), 1e-9 * values[11]);
  EXPECT_GT(values[7], 1e-6 * values[11]);
}

} // namespace
} // namespace towform
