#include "material/fabric_law.hpp"
#include "material/gf_pp.hpp"
#include "material/shear_resistance.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

constexpr double degree = M_PI / 180.0;

MaterialParameters twill(LawKind law)
{
  MaterialParameters m;
  m.constituents = test::gf_pp_twill();
  m.temperature = 463.15;
  m.law = law;
  m.curve_rate_min = 1.0;
  m.curve_rate_max = 20.0;
  m.curve_count = 20;
  m.elastic_rate = 10.0;
  m.fibre_modulus = 1e9;
  m.relaxation_ratio = 0.1;
  return m;
}

const ShearResistance& model()
{
  static const ShearResistance m(test::gf_pp_twill(), 1e-3, 463.15);
  return m;
}

TEST(ShearTable, FollowsTheModelBetweenItsPoints)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::viscous), 1e-3);
  double worst = 0.0;
  for (double theta = 0.05 * degree; theta < 80.0 * degree; theta += 0.73 * degree)
    for (double rate = 0.0101; rate < 5000.0; rate *= 1.137)
      worst =
          std::max(worst, std::abs(material.surface->force(theta, rate) / model().force(theta, rate) - 1.0));
  // Straight lines over 1/4 octave of a power law (n = 0.35 .. 1) and 0.25 degrees of 1/cos^3.
  EXPECT_LT(worst, 2e-3);
  EXPECT_EQ(material.surface->force(0.5, 0.0), 0.0);
  EXPECT_EQ(material.surface->force(-0.5, 3.0), material.surface->force(0.5, 3.0));
}

TEST(ShearCurves, FitTheModelAndTheirSlopeIsTheirDerivative)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::incremental), 1e-3);
  EXPECT_LT(material.curves->fit_error, 0.005);
  const ShearCurve& curve = material.curves->curves[4];
  EXPECT_DOUBLE_EQ(curve.rate(), 5.0);
  for (const double theta : {0.1, 0.6, 1.1, 1.4}) { // 1.4 rad is beyond the fit: a straight line
    const double step = 1e-6;
    EXPECT_NEAR(curve.slope(theta), (curve.force(theta + step) - curve.force(theta - step)) / (2.0 * step),
                1e-6 * curve.slope(theta) + 1e-6);
  }
}

TEST(ShearCurves, IndicatorCountsTheNextHigherCurve)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::incremental), 1e-3);
  EXPECT_EQ(material.curves->next_higher(0.1), 1);
  EXPECT_EQ(material.curves->next_higher(2.5), 3);
  EXPECT_EQ(material.curves->next_higher(3.0), 3);
  EXPECT_EQ(material.curves->next_higher(99.0), 20);
  EXPECT_DOUBLE_EQ(material.curves->position(2.5), 2.5);
}

TEST(ViscousLaw, SitsOnTheSurfaceInSteadyShear)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::viscous), 1e-3);
  const auto& law = std::get<ViscousLaw>(material.law);
  for (const double rate : {0.5, 10.0}) {
    ShearPoint p;
    const double dt = 5e-6;
    double angle = 0.0;
    while (angle < 0.4) law.update(p, angle += rate * dt, dt);
    EXPECT_NEAR(p.rate, rate, 0.01 * rate); // the spring still stretches as N grows with the angle
    EXPECT_NEAR(p.force, material.surface->force(p.angle, p.rate), 1e-6 * p.force);
  }
}

TEST(ViscousLaw, RelaxesWhenFormingStopsAndOpposesReversal)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::viscous), 1e-3);
  const auto& law = std::get<ViscousLaw>(material.law);
  ShearPoint p;
  const double dt = 5e-6;
  double angle = 0.0;
  while (angle < 0.3) law.update(p, angle += 20.0 * dt, dt);
  const double loaded = p.force;
  for (int i = 0; i < 4000; ++i) law.update(p, angle, dt); // 20 ms
  EXPECT_GT(p.force, 0.0);
  EXPECT_LT(p.force, 0.01 * loaded);
  for (int i = 0; i < 1000; ++i) law.update(p, angle -= 20.0 * dt, dt);
  EXPECT_LT(p.force, -0.5 * loaded);
}

TEST(ViscousLaw, NeverGivesBackMoreThanWasPutIn)
{
  // Work over a closed path of angles is what was dissipated: positive, and equal to the sum of |N| rate dt
  // once the spring is empty again.
  const FabricMaterial material = make_fabric_material(twill(LawKind::viscous), 1e-3);
  const auto& law = std::get<ViscousLaw>(material.law);
  ShearPoint p;
  const double dt = 2e-6;
  double work = 0.0, dissipated = 0.0;
  const int steps = 20000;
  for (int i = 1; i <= 2 * steps; ++i) {
    const double before = p.force, from = p.angle;
    const double angle = i <= steps ? 0.2 * (1.0 - std::cos(2.0 * M_PI * i / steps)) : 0.0;
    dissipated += law.update(p, angle, dt) * dt;
    work += 0.5 * (before + p.force) * (angle - from);
  }
  EXPECT_GT(work, 0.0);
  EXPECT_NEAR(work, dissipated, 0.01 * dissipated);
}

TEST(ViscousLaw, IsStableAtAnyStep)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::viscous), 1e-3);
  const auto& law = std::get<ViscousLaw>(material.law);
  for (const double dt : {1e-9, 1e-6, 1e-3, 1.0}) {
    ShearPoint p;
    for (int i = 0; i < 200; ++i) {
      law.update(p, i % 2 == 0 ? 0.3 : -0.3, dt);
      ASSERT_TRUE(std::isfinite(p.force));
      ASSERT_LE(std::abs(p.force), 200 * 0.6 * law.modulus);
      ASSERT_NEAR(std::abs(p.force), material.surface->force(p.angle, p.rate),
                  1e-6 * std::abs(p.force) + 1e-9);
    }
  }
}

TEST(IncrementalLaw, IntegratesTheSlopeOfTheChosenCurve)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::incremental), 1e-3);
  const auto& law = std::get<IncrementalLaw>(material.law);
  ShearPoint p;
  const double rate = 4.5, dt = 1e-5; // between curves 4 and 5: the fifth is used
  for (int i = 1; i * rate * dt < 0.8; ++i) law.update(p, i * rate * dt, dt);
  const ShearCurve& fifth = material.curves->curves[4];
  EXPECT_NEAR(p.force, fifth.force(p.angle) - fifth.force(0.0), 1e-6 * p.force);
}

TEST(ElasticLaw, IsOddAndFollowsItsCurve)
{
  const FabricMaterial material = make_fabric_material(twill(LawKind::elastic), 1e-3);
  const auto& law = std::get<ElasticLaw>(material.law);
  ShearPoint p;
  law.update(p, 0.5, 1e-5);
  EXPECT_NEAR(p.force, model().force(0.5, 10.0), 0.005 * p.force);
  const double force = p.force;
  law.update(p, -0.5, 1e-5);
  EXPECT_DOUBLE_EQ(p.force, -force);
  law.update(p, 0.0, 1e-5);
  EXPECT_EQ(p.force, 0.0);
}

} // namespace
} // namespace towform
