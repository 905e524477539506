#include "material/gf_pp.hpp"
#include "material/minimum.hpp"
#include "material/shear_resistance.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

constexpr double temperature = 463.15;

TEST(MinimumOf, FindsVerticesAndEnds)
{
  EXPECT_NEAR(minimum_of([](double x) { return (x - 0.3) * (x - 0.3) + 2.0; }, 0.0, 1.0), 0.3, 1e-10);
  EXPECT_NEAR(minimum_of([](double x) { return std::pow(std::abs(x - 0.7), 1.35); }, 0.0, 1.0), 0.7, 1e-4);
  EXPECT_NEAR(minimum_of([](double x) { return x * x; }, 0.0, 1.0), 0.0, 1e-12);
  EXPECT_NEAR(minimum_of([](double x) { return (x - 2.0) * (x - 2.0); }, 0.0, 1.0), 1.0, 1e-12);
}

TEST(MinimumPower, IsTheVertexOfAQuadraticWhenNewtonian)
{
  // Powers per area over eta: tows a x^2, gaps b (rate - f_t x)^2, films c (rate - x)^2, so that the least
  // is at x = rate (b f_t + c)/(a + b f_t^2 + c).
  for (const CrossoverField field : {CrossoverField::derived, CrossoverField::printed}) {
    Constituents sheet = test::newtonian_twill(300.0);
    sheet.tow_kinematics = TowKinematics::minimum_power;
    sheet.crossover_field = field;
    const double h = 1e-3, ft = 0.91, fm = 0.09, rate = 3.0, pitch = 5e-3, width = 4.55e-3;
    const ShearResistance model(sheet, h, temperature);
    const double a =
        h * ft * tow_viscosity_ratios(0.35 / ft, sheet.tow_viscosity, sheet.fibre_packing).longitudinal;
    const double b = h * sheet.weave_factor / fm;
    for (const double theta : {0.0, 0.2, 0.7, 1.2, ShearResistance::max_angle}) {
      const double s = std::sin(theta), cosine = std::cos(theta);
      const double shape =
          field == CrossoverField::derived ? std::pow(cosine, 3) : cosine * std::pow(1.0 - s, 2);
      const double c = std::pow(width, 4) / 6.0 * shape / model.film_thickness() / (pitch * pitch);
      const double exact = rate * (b * ft + c) / (a + b * ft * ft + c);
      EXPECT_NEAR(model.tow_rate(theta, rate), exact, 1e-7 * rate) << theta;
    }
  }
}

TEST(MinimumPower, NoOtherTowRateDissipatesLess)
{
  Constituents sheet = test::gf_pp_twill();
  const ShearResistance measured(sheet, 1e-3, temperature);
  sheet.tow_kinematics = TowKinematics::minimum_power;
  const ShearResistance least(sheet, 1e-3, temperature);
  for (const double rate : {0.01, 1.0, 100.0})
    for (double theta = 0.0; theta < 1.45; theta += 0.1) {
      const double power = least.power(theta, rate, least.tow_rate(theta, rate)).total();
      for (double tow = -0.5; tow < 1.6; tow += 0.01)
        EXPECT_LE(power, least.power(theta, rate, tow * rate).total() * (1.0 + 1e-9));
      EXPECT_LE(least.force(theta, rate), measured.force(theta, rate));
    }
}

TEST(MinimumPower, WithoutGapsTowsShearWithTheSheet)
{
  Constituents sheet = test::gf_pp_twill();
  sheet.tow_gap = 0.0;
  for (const TowKinematics kinematics : {TowKinematics::measured, TowKinematics::minimum_power}) {
    sheet.tow_kinematics = kinematics;
    const ShearResistance model(sheet, 1e-3, temperature);
    EXPECT_EQ(model.tow_rate(0.4, 2.0), 2.0);
    EXPECT_EQ(model.parts(0.4, 2.0).inter_tow, 0.0);
    EXPECT_EQ(model.parts(0.4, 2.0).crossover, 0.0);
  }
}

TEST(ShearResistance, RejectsAnglesAndRatesOutOfRange)
{
  const ShearResistance model(test::gf_pp_twill(), 1e-3, temperature);
  const double degree = M_PI / 180.0;
  EXPECT_NO_THROW(static_cast<void>(model.force(85.0 * degree, 1.0)));
  EXPECT_THROW(static_cast<void>(model.force(85.1 * degree, 1.0)), std::domain_error);
  EXPECT_THROW(static_cast<void>(model.force(-0.1, 1.0)), std::domain_error);
  EXPECT_THROW(static_cast<void>(model.force(NAN, 1.0)), std::domain_error);
  EXPECT_THROW(static_cast<void>(model.force(0.1, 0.0)), std::domain_error);
  EXPECT_THROW(static_cast<void>(model.force(0.1, -1.0)), std::domain_error);
  EXPECT_THROW(ShearResistance(test::gf_pp_twill(), 0.0, temperature), std::domain_error);
}

} // namespace
} // namespace towform
