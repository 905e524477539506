#include "material/gf_pp.hpp"
#include "material/shear_resistance.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace towform {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double temperature = 463.15;

TEST(TowKinematics, MatchesTheMeasuredProfile)
{
  // Figures of the physics page, printed to four digits.
  EXPECT_NEAR(measured_tow_shear_ratio(0.0), 0.770, 5e-4);
  EXPECT_NEAR(measured_tow_shear_ratio(20.0 * degree), 0.2327, 5e-5);
  EXPECT_NEAR(measured_tow_shear_ratio(30.0 * degree), 0.0845, 5e-5);
  EXPECT_NEAR(measured_tow_shear_ratio(45.0 * degree), 0.0065, 5e-5);
  EXPECT_NEAR(measured_tow_shear_ratio(60.0 * degree), -0.0355, 5e-5);
}

TEST(TowViscosity, CoffinLimitAndHexagonalCell)
{
  const double kappa = fibre_closeness(0.6, FibrePacking::square);
  EXPECT_DOUBLE_EQ(kappa, std::sqrt(0.6 / (std::numbers::pi / 4.0)));
  const auto coffin = tow_viscosity_ratios(0.6, TowViscosity::coffin, FibrePacking::square);
  EXPECT_DOUBLE_EQ(coffin.longitudinal, 0.5 * (1.0 + 1.0 / (1.0 - kappa)));
  EXPECT_DOUBLE_EQ(coffin.transverse, 1.0 / ((1.0 - kappa) * (1.0 - kappa)));

  for (const auto& [f, ratio] : {std::pair{0.20, 1.5055}, {0.50, 3.6613}, {0.80, 41.82}})
    EXPECT_NEAR(tow_viscosity_ratios(f, TowViscosity::hexagonal_cell, FibrePacking::hexagonal).transverse,
                ratio, 1e-12 * ratio);
  double last = 0.0; // monotone between the table's points
  for (double f = 0.2; f <= 0.8; f += 0.005) {
    const double ratio =
        tow_viscosity_ratios(f, TowViscosity::hexagonal_cell, FibrePacking::hexagonal).transverse;
    EXPECT_GT(ratio, last);
    last = ratio;
  }
  // Dilute limit of aligned rigid fibres: 1 + 2 f + O(f^2).
  EXPECT_NEAR(tow_viscosity_ratios(0.2, TowViscosity::hexagonal_cell, FibrePacking::hexagonal).longitudinal,
              1.0 + 2.0 * 0.2 / 0.8, 1e-4);
  EXPECT_THROW(tow_viscosity_ratios(0.81, TowViscosity::hexagonal_cell, FibrePacking::hexagonal),
               std::domain_error);
}

TEST(ShearResistance, CrossoverPowerIsExactForConstantViscosity)
{
  const double eta = 250.0, width = 4.55e-3;
  Constituents sheet = test::newtonian_twill(2.0 * eta); // lambda = 0 with 0 < n < 1: eta0 / (1 + 0)
  sheet.matrix.zero_shear_viscosity = eta;
  for (const double theta : {0.0, 0.3, 0.9, 1.3}) {
    const double rate = 3.0, tow_rate = 0.4, cosine = std::cos(theta), s = std::sin(theta);
    const double scale = std::pow(rate - tow_rate, 2) * std::pow(width, 4) / 6.0;

    sheet.crossover_field = CrossoverField::derived;
    const ShearResistance derived(sheet, 1e-3, temperature);
    const double exact = eta / derived.film_thickness() * scale * std::pow(cosine, 3);
    EXPECT_NEAR(derived.crossover_power(theta, rate, tow_rate), exact, 1e-12 * exact);

    sheet.crossover_field = CrossoverField::printed;
    const ShearResistance printed(sheet, 1e-3, temperature);
    const double exact_printed = eta / printed.film_thickness() * scale * cosine * (1.0 - s) * (1.0 - s);
    EXPECT_NEAR(printed.crossover_power(theta, rate, tow_rate), exact_printed, 1e-12 * exact_printed);
  }
}

TEST(ShearResistance, NewtonianSheetByHand)
{
  // At theta = 0 only simple shear is left: every part is its viscosity times its rate squared.
  const double eta = 100.0, rate = 2.0, h = 1e-3;
  const Constituents sheet = test::newtonian_twill(eta);
  const ShearResistance model(sheet, h, temperature);
  const double ft = 0.91, fm = 0.09, gamma_t = measured_tow_shear_ratio(0.0);
  const double gamma_m = (1.0 - ft * gamma_t) / fm;
  const auto ratios = tow_viscosity_ratios(0.35 / ft, TowViscosity::hexagonal_cell, FibrePacking::hexagonal);
  const auto parts = model.parts(0.0, rate);
  EXPECT_NEAR(parts.tow, h * ft * ratios.longitudinal * eta * gamma_t * gamma_t * rate, 1e-12);
  EXPECT_NEAR(parts.inter_tow, h * fm * eta * gamma_m * gamma_m * rate, 1e-12);
  const double film =
      17e-6 * (1.0 / std::sqrt(0.35 / ft / (std::numbers::pi / (2.0 * std::numbers::sqrt3))) - 1.0);
  EXPECT_NEAR(model.film_thickness(), film, 1e-15);
  EXPECT_NEAR(parts.crossover,
              eta / film * std::pow(1.0 - gamma_t, 2) * std::pow(4.55e-3, 4) / 6.0 / 25e-6 * rate, 1e-9);
}

TEST(ShearResistance, IsLinearInRateWhenNewtonianAndThinsOtherwise)
{
  const ShearResistance newtonian(test::newtonian_twill(300.0), 1e-3, temperature);
  const ShearResistance thinning(test::gf_pp_twill(), 1e-3, temperature);
  for (const double theta : {0.1, 0.7, 1.2}) {
    EXPECT_NEAR(newtonian.force(theta, 8.0) / newtonian.force(theta, 2.0), 4.0, 1e-12);
    const double ratio = thinning.force(theta, 8.0) / thinning.force(theta, 2.0);
    EXPECT_GT(ratio, 1.0);
    EXPECT_LT(ratio, 4.0);
  }
}

TEST(ShearResistance, ArrheniusShiftsViscosityAndTimeTogether)
{
  // The same shear force at another temperature, at the rate shifted by 1/a_T: N(rate/a, T) = N(rate, Tref).
  const double hot = 483.15;
  const double a = std::exp(40e3 / 8.31446261815324 * (1.0 / hot - 1.0 / temperature));
  const ShearResistance reference(test::gf_pp_twill(), 1e-3, temperature),
      warm(test::gf_pp_twill(), 1e-3, hot);
  EXPECT_LT(a, 1.0);
  EXPECT_NEAR(warm.force(0.6, 5.0 / a), reference.force(0.6, 5.0), 1e-9 * reference.force(0.6, 5.0));
}

TEST(ShearResistance, NamesTheConstituentOutOfRange)
{
  const auto message = [](auto change) {
    Constituents c = test::gf_pp_twill();
    change(c);
    try {
      ShearResistance(c, 1e-3, temperature);
    } catch (const std::domain_error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(message([](Constituents& c) { c.tow_gap = -1e-4; }).find("tow_gap"), std::string::npos);
  EXPECT_NE(message([](Constituents& c) { c.fibre_volume_fraction = 0.85; }).find("packing limit 0.907"),
            std::string::npos);
  EXPECT_NE(message([](Constituents& c) { c.fibre_volume_fraction = 0.1; }).find("coffin"),
            std::string::npos);
}

} // namespace
} // namespace towform
