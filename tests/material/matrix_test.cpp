#include "material/gf_pp.hpp"
#include "material/viscosity.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

constexpr double reference = 463.15;

MatrixViscosity matrix(MatrixModel model)
{
  MatrixViscosity m = test::gf_pp_twill().matrix; // 300 Pa s, 0.03 s, n = 0.35
  m.model = model;
  return m;
}

double viscosity(const MatrixViscosity& m, double rate, double temperature = reference)
{
  return IsothermalMatrix(m, temperature).viscosity(rate);
}

TEST(MatrixViscosity, FormulasByHand)
{
  EXPECT_DOUBLE_EQ(viscosity(matrix(MatrixModel::cross), 100.0), 300.0 / (1.0 + std::pow(3.0, 0.65)));
  MatrixViscosity carreau = matrix(MatrixModel::carreau_yasuda);
  EXPECT_DOUBLE_EQ(viscosity(carreau, 100.0), 300.0 * std::pow(1.0 + 9.0, -0.325));
  carreau.transition = 0.7;
  EXPECT_DOUBLE_EQ(viscosity(carreau, 100.0), 300.0 * std::pow(1.0 + std::pow(3.0, 0.7), -0.65 / 0.7));
  EXPECT_DOUBLE_EQ(viscosity(carreau, 0.0), 300.0);
}

TEST(MatrixViscosity, PowerLawIsCappedBelowItsRate)
{
  const MatrixViscosity m = matrix(MatrixModel::power_law);
  const double consistency = 300.0 * std::pow(0.03, -0.65); // K [Pa s^n]
  EXPECT_NEAR(viscosity(m, 200.0), consistency * std::pow(200.0, -0.65), 1e-12 * 300.0);
  EXPECT_EQ(viscosity(m, 33.0), 300.0);
  EXPECT_EQ(viscosity(m, 0.0), 300.0);
}

TEST(MatrixViscosity, TableIsStraightInLogarithms)
{
  MatrixViscosity m = matrix(MatrixModel::table);
  m.points = {{0.1, 300.0}, {10.0, 150.0}, {1000.0, 15.0}};
  EXPECT_NEAR(viscosity(m, 10.0), 150.0, 1e-10);
  EXPECT_NEAR(viscosity(m, 1.0), std::sqrt(300.0 * 150.0), 1e-10); // half-way in the logarithm
  EXPECT_NEAR(viscosity(m, 100.0), std::sqrt(150.0 * 15.0), 1e-10);
  EXPECT_NEAR(viscosity(m, 1e5), 1.5, 1e-10); // the last decade pair goes on
  EXPECT_DOUBLE_EQ(viscosity(m, 0.01), 300.0);
  EXPECT_DOUBLE_EQ(viscosity(m, 0.0), 300.0);
}

TEST(MatrixViscosity, EveryModelShiftsAlongBothAxes)
{
  // eta(rate, T) = a_T eta(a_T rate, Tr), whatever the model and the shift.
  for (const MatrixModel model :
       {MatrixModel::cross, MatrixModel::carreau_yasuda, MatrixModel::power_law, MatrixModel::table}) {
    MatrixViscosity m = matrix(model);
    m.points = {{0.1, 300.0}, {10.0, 150.0}, {1000.0, 15.0}};
    m.wlf_c1 = 3.0;
    m.wlf_c2 = 180.0;
    for (const TemperatureShift shift : {TemperatureShift::arrhenius, TemperatureShift::wlf}) {
      m.shift = shift;
      const double hot = 490.0, a = temperature_shift(m, hot);
      EXPECT_LT(a, 1.0);
      EXPECT_NEAR(viscosity(m, 40.0, hot), a * viscosity(m, a * 40.0), 1e-10);
      EXPECT_DOUBLE_EQ(temperature_shift(m, reference), 1.0);
    }
  }
}

TEST(MatrixViscosity, WlfByHand)
{
  MatrixViscosity m = matrix(MatrixModel::cross);
  m.shift = TemperatureShift::wlf;
  m.wlf_c1 = 3.0;
  m.wlf_c2 = 180.0;
  EXPECT_NEAR(temperature_shift(m, reference + 20.0), std::pow(10.0, -3.0 * 20.0 / 200.0), 1e-14);
  EXPECT_THROW(static_cast<void>(temperature_shift(m, reference - 180.0)), std::domain_error);
}

TEST(MatrixViscosity, NamesWhatIsOutOfRange)
{
  const auto message = [](auto change, double temperature = reference) {
    MatrixViscosity m = matrix(MatrixModel::carreau_yasuda);
    change(m);
    try {
      const IsothermalMatrix made(m, temperature);
    } catch (const std::domain_error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  const auto keep = [](MatrixViscosity&) {};
  EXPECT_EQ(message(keep), "accepted");
  EXPECT_EQ(message(keep, -3.0), "temperature must be above absolute zero, not -3 K");
  EXPECT_EQ(message([](auto& m) { m.zero_shear_viscosity = 0.0; }),
            "matrix.zero_shear_viscosity must be positive, not 0 Pa s");
  EXPECT_EQ(message([](auto& m) { m.exponent = 1.2; }),
            "matrix.exponent must be above 0 and at most 1, not 1.2");
  EXPECT_EQ(message([](auto& m) { m.time_constant = NAN; }),
            "matrix.time_constant must not be negative, not nan s");
  EXPECT_EQ(message([](auto& m) { m.transition = 0.0; }), "matrix.transition must be positive, not 0");
  EXPECT_EQ(message([](auto& m) { m.activation_energy = -1.0; }),
            "matrix.activation_energy must not be negative, not -1 J/mol");
  EXPECT_EQ(message([](auto& m) { m.shift = TemperatureShift::wlf; }),
            "matrix.wlf_c2 must be positive, not 0 K");
  EXPECT_EQ(message([](auto& m) {
              m.model = MatrixModel::table;
              m.points = {{1.0, 100.0}, {10.0, 5.0}};
            }),
            "matrix.table: rate x viscosity must not fall from one point to the next, not 50 Pa");
}

} // namespace
} // namespace towform
