#include "material/viscosity.hpp"
#include "case/float_traps.hpp"
#include "material/require.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {
constexpr double gas_constant = 8.31446261815324; // [J/(mol K)], exact since 2019

void check_points(const std::vector<ViscosityPoint>& points)
{
  require(points.size() >= 2, "matrix.table", "have two points or more", static_cast<double>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(points[i].rate > 0.0, "matrix.table: a rate", "be positive", points[i].rate, "1/s");
    require(points[i].viscosity > 0.0, "matrix.table: a viscosity", "be positive", points[i].viscosity,
            "Pa s");
    if (i == 0) continue;
    require(points[i].rate > points[i - 1].rate, "matrix.table: a rate", "be above the one before it",
            points[i].rate, "1/s");
    const double stress = points[i].rate * points[i].viscosity;
    require(stress >= points[i - 1].rate * points[i - 1].viscosity, "matrix.table: rate x viscosity",
            "not fall from one point to the next", stress, "Pa");
  }
}
} // namespace

double temperature_shift(const MatrixViscosity& m, double temperature)
{
  const UntrappedFloats judging;
  require(temperature > 0.0, "temperature", "be above absolute zero", temperature, "K");
  require(m.reference_temperature > 0.0, "matrix.reference_temperature", "be above absolute zero",
          m.reference_temperature, "K");
  const double above = temperature - m.reference_temperature;
  if (m.shift == TemperatureShift::wlf) {
    require(m.wlf_c1 >= 0.0, "matrix.wlf_c1", "not be negative", m.wlf_c1);
    require(m.wlf_c2 > 0.0, "matrix.wlf_c2", "be positive", m.wlf_c2, "K");
    require(above > -m.wlf_c2, "temperature",
            "be above matrix.reference_temperature - wlf_c2, where the WLF shift ends", temperature, "K");
    return std::pow(10.0, -m.wlf_c1 * above / (m.wlf_c2 + above));
  }
  require(m.activation_energy >= 0.0, "matrix.activation_energy", "not be negative", m.activation_energy,
          "J/mol");
  return std::exp(m.activation_energy / gas_constant * (1.0 / temperature - 1.0 / m.reference_temperature));
}

IsothermalMatrix::IsothermalMatrix(const MatrixViscosity& m, double temperature)
    : model_(m.model), exponent_(m.exponent), transition_(m.transition)
{
  const UntrappedFloats judging;
  const double shift = temperature_shift(m, temperature);
  require(std::isfinite(shift) && shift > 0.0, "the viscosity's shift at this temperature",
          "be a positive number", shift);
  zero_shear_viscosity_ = m.zero_shear_viscosity * shift;
  time_constant_ = m.time_constant * shift;
  if (model_ == MatrixModel::table) {
    check_points(m.points);
    time_constant_ = 1.0;
    for (const ViscosityPoint& p : m.points)
      points_.push_back({std::log(p.rate / shift), std::log(p.viscosity * shift)});
    return;
  }
  require(m.zero_shear_viscosity > 0.0, "matrix.zero_shear_viscosity", "be positive", m.zero_shear_viscosity,
          "Pa s");
  require(m.time_constant >= 0.0, "matrix.time_constant", "not be negative", m.time_constant, "s");
  require(m.exponent > 0.0 && m.exponent <= 1.0, "matrix.exponent", "be above 0 and at most 1", m.exponent);
  if (model_ == MatrixModel::carreau_yasuda)
    require(m.transition > 0.0, "matrix.transition", "be positive", m.transition);
}

double IsothermalMatrix::raised(double factor) const
{
  switch (model_) {
  case MatrixModel::cross:
  case MatrixModel::power_law:
    return std::pow(factor, 1.0 - exponent_);
  case MatrixModel::carreau_yasuda:
    return std::pow(factor, transition_);
  case MatrixModel::table:
    break;
  }
  return factor;
}

double IsothermalMatrix::viscosity_raised(double rate) const
{
  switch (model_) {
  case MatrixModel::cross:
    return zero_shear_viscosity_ / (1.0 + rate);
  case MatrixModel::carreau_yasuda:
    return zero_shear_viscosity_ * std::pow(1.0 + rate, (exponent_ - 1.0) / transition_);
  case MatrixModel::power_law:
    return zero_shear_viscosity_ / std::max(1.0, rate);
  case MatrixModel::table:
    return tabulated(rate);
  }
  return zero_shear_viscosity_;
}

double IsothermalMatrix::tabulated(double rate) const
{
  const double x = rate > 0.0 ? std::log(rate) : points_.front().rate;
  if (x <= points_.front().rate) return std::exp(points_.front().viscosity);
  const auto inner =
      std::find_if(points_.begin() + 1, points_.end() - 1, [x](const LogPoint& p) { return p.rate >= x; });
  const LogPoint &low = *(inner - 1), &high = *inner;
  const double slope = (high.viscosity - low.viscosity) / (high.rate - low.rate);
  return std::exp(low.viscosity + slope * (x - low.rate));
}

} // namespace towform
