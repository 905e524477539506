#pragma once
#include "towform/energy_model.hpp"
#include <vector>

namespace towform {

/// The matrix at one temperature: eta(rate) [Pa s], rate >= 0 in 1/s (physics: energy model, Matrix; the
/// equations stand at MatrixModel and TemperatureShift). It is a fluid that resists more the faster it
/// flows: eta(rate) rate never falls.
class IsothermalMatrix {
public:
  /// T in K. Throws std::domain_error naming the parameter that is out of range.
  IsothermalMatrix(const MatrixViscosity& matrix, double temperature);

  [[nodiscard]] double viscosity(double rate) const { return viscosity_raised(raised(time_constant_ * rate)); }

  /// For the products of some rates with some factors: eta(factor rate) is viscosity_raised(raised(factor) raised_rate(rate)), and
  /// raising is what takes time.
  [[nodiscard]] double raised(double factor) const;
  [[nodiscard]] double raised_rate(double rate) const { return raised(time_constant_ * rate); }
  [[nodiscard]] double viscosity_raised(double rate) const;

private:
  [[nodiscard]] double tabulated(double rate) const;

  MatrixModel model_;
  double zero_shear_viscosity_, time_constant_, exponent_, transition_; // eta0 and lambda shifted; lambda 1 for a table
  struct LogPoint {
    double rate, viscosity;
  };
  std::vector<LogPoint> points_; // natural logarithms, shifted
};

/// a_T = eta0(T)/eta0(Tr). Throws std::domain_error when a temperature is outside the shift's range.
double temperature_shift(const MatrixViscosity& matrix, double temperature);

} // namespace towform
