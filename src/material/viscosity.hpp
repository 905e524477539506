#pragma once
#include "towform/energy_model.hpp"

namespace towform {

/// The matrix at one temperature: eta0 and lambda already shifted.
/// Cross: eta(rate) = eta0 / (1 + (lambda rate)^(1-n))   [Pa s], rate >= 0 in 1/s (physics: energy model,
/// Matrix).
struct IsothermalMatrix {
  double zero_shear_viscosity; ///< [Pa s]
  double time_constant;        ///< [s]
  double exponent;             ///< n

  [[nodiscard]] double viscosity(double rate) const;
};

/// Arrhenius shift exp(Ea/R (1/T - 1/Tref)) of eta0 and lambda alike. T in K.
IsothermalMatrix at_temperature(const MatrixViscosity& matrix, double temperature);

} // namespace towform
