#include "material/viscosity.hpp"
#include <cmath>

namespace towform {

namespace {
constexpr double gas_constant = 8.31446261815324; // [J/(mol K)], exact since 2019
}

double IsothermalMatrix::viscosity(double rate) const
{
  return zero_shear_viscosity / (1.0 + std::pow(time_constant * rate, 1.0 - exponent));
}

IsothermalMatrix at_temperature(const MatrixViscosity& matrix, double temperature)
{
  const double shift = std::exp(matrix.activation_energy / gas_constant *
                                (1.0 / temperature - 1.0 / matrix.reference_temperature));
  return {matrix.zero_shear_viscosity * shift, matrix.time_constant * shift, matrix.exponent};
}

} // namespace towform
