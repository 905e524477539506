#include "material/shear_resistance.hpp"
#include "case/float_traps.hpp"
#include "material/minimum.hpp"
#include "material/require.hpp"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform {

namespace {
// Gauss-Legendre points and weights of order 10 on [0, 1].
constexpr int points = ShearResistance::film_points;
constexpr std::array<double, points> gauss_x{
    0.013046735741414128, 0.06746831665550773, 0.16029521585048778, 0.2833023029353764, 0.4255628305091844,
    0.5744371694908156,   0.7166976970646236,  0.8397047841495122,  0.9325316833444923, 0.9869532642585859};
constexpr std::array<double, points> gauss_w{0.033335672154344069, 0.074725674575290293, 0.10954318125799103,
                                             0.13463335965499817,  0.14776211235737643,  0.14776211235737643,
                                             0.13463335965499817,  0.10954318125799103,  0.074725674575290293,
                                             0.033335672154344069};
} // namespace

ShearResistance::ShearResistance(const Constituents& c, double thickness, double temperature)
    : sheet_(c), thickness_(thickness), matrix_(c.matrix, temperature)
{
  const UntrappedFloats judging;
  require(thickness > 0.0, "thickness", "be positive", thickness, "m");
  require(c.fibre_volume_fraction > 0.0, "fibre_volume_fraction", "be positive", c.fibre_volume_fraction);
  require(c.tow_width > 0.0, "tow_width", "be positive", c.tow_width, "m");
  require(c.tow_gap >= 0.0, "tow_gap", "not be negative", c.tow_gap, "m");
  require(c.fibre_diameter > 0.0, "fibre_diameter", "be positive", c.fibre_diameter, "m");
  require(c.weave_factor > 0.0, "weave_factor", "be positive", c.weave_factor);
  tow_share_ = c.tow_width / (c.tow_width + c.tow_gap);
  gap_share_ = 1.0 - tow_share_;
  tow_fraction_ = c.fibre_volume_fraction / tow_share_;
  closeness_ = fibre_closeness(tow_fraction_, c.fibre_packing);
  if (closeness_ >= 1.0)
    throw std::domain_error(fmt::format(
        "the fibre fraction inside a tow, fibre_volume_fraction (tow_width + tow_gap)/tow_width = "
        "{:.3f}, must be below the packing limit {:.3f}",
        tow_fraction_, tow_fraction_ / (closeness_ * closeness_)));
  film_ = c.fibre_diameter * (1.0 / closeness_ - 1.0);
  ratios_ = tow_viscosity_ratios(tow_fraction_, c.tow_viscosity, c.fibre_packing);
  for (std::size_t i = 0; i < gauss_x.size(); ++i) raised_x_[i] = matrix_.raised(gauss_x[i]);
}

double ShearResistance::crossover_power(double theta, double rate, double tow_rate) const
{
  // The rhombus has half diagonals (a, b); by symmetry one quarter of it, mapped from the centre outwards
  // (X = a rho (1-t), Y = b rho t), where |v| is proportional to rho.
  const double s = std::sin(theta);
  const double a = sheet_.tow_width * std::sqrt(0.5 * (1.0 + s));
  const double b = sheet_.tow_width * std::sqrt(0.5 * (1.0 - s));
  const double along = sheet_.crossover_field == CrossoverField::derived ? 1.0 + s : 1.0 - s;
  const double across = 1.0 - s;
  double power = 0.0;
  for (int i = 0; i < points; ++i) {
    const double v = std::abs(tow_rate - rate) *
                     std::hypot(along * b * gauss_x[i], across * a * (1.0 - gauss_x[i])); // |v| at rho = 1
    const double raised_rate = matrix_.raised_rate(v / film_);
    for (int j = 0; j < points; ++j) {
      const double film_rate = v * gauss_x[j] / film_, viscosity = matrix_.viscosity_raised(raised_x_[j] * raised_rate);
      power += gauss_w[i] * gauss_w[j] * gauss_x[j] * viscosity * film_rate * film_rate;
    }
  }
  return 4.0 * a * b * film_ * power;
}

double ShearResistance::tow_rate(double theta, double rate) const
{
  // Without gaps between tows they must shear with the sheet.
  if (gap_share_ <= 0.0) return rate;
  if (sheet_.tow_kinematics == TowKinematics::measured) return measured_tow_shear_ratio(theta) * rate;
  // The tows would rather not shear, the films want them to shear with the sheet (theta_dot) and the gaps
  // want to be left out (theta_dot/f_t): the least power lies between the first and the last.
  const auto total = [&](double tow) { return power(theta, rate, tow).total(); };
  return minimum_of(total, 0.0, rate / tow_share_);
}

ShearResistance::Parts ShearResistance::power(double theta, double rate, double tow_rate) const
{
  const double spin = 2.0 * rate * std::tan(theta);
  const double magnified = 1.0 / (1.0 - closeness_);
  const double eta_l = ratios_.longitudinal * matrix_.viscosity(std::abs(tow_rate) * magnified);
  const double eta_t = ratios_.transverse * matrix_.viscosity(spin * magnified);
  const double pitch = sheet_.tow_width + sheet_.tow_gap;
  Parts result;
  result.tow = thickness_ * tow_share_ * (eta_t * spin * spin + eta_l * tow_rate * tow_rate);
  if (gap_share_ > 0.0) {
    const double gap_rate = (rate - tow_share_ * tow_rate) / gap_share_;
    const double gap_rate_2 = spin * spin + gap_rate * gap_rate;
    result.inter_tow =
        thickness_ * gap_share_ * sheet_.weave_factor * matrix_.viscosity(std::sqrt(gap_rate_2)) * gap_rate_2;
  }
  result.crossover = crossover_power(theta, rate, tow_rate) / (pitch * pitch);
  return result;
}

ShearResistance::Parts ShearResistance::parts(double theta, double rate) const
{
  constexpr double rounding = 1e-12, degree = max_angle / 85.0;
  {
    const UntrappedFloats judging;
    require(theta >= 0.0 && theta <= max_angle + rounding, "a shear angle", "be within 0 and 85",
            theta / degree, "deg");
    require(rate > 0.0, "an angular rate", "be positive", rate, "rad/s");
  }
  const Parts p = power(theta, rate, tow_rate(theta, rate));
  const double to_force = 1.0 / (rate * std::cos(theta));
  return {p.tow * to_force, p.inter_tow * to_force, p.crossover * to_force};
}

} // namespace towform
