#pragma once
#include "material/tow.hpp"
#include "material/viscosity.hpp"
#include "towform/energy_model.hpp"
#include <array>

namespace towform {

/// The unit-cell energy model at one temperature: shear force per unit length of a sheet from its
/// constituents, N_s = p_A/(theta_dot cos theta) [N/m], with the power dissipated per initial area
///   p_A = h f_t (4 eta_T theta_dot^2 tan^2 theta + eta_L gamma_t^2)              tows              (Eq. 4)
///       + h f_m q eta_m (4 theta_dot^2 tan^2 theta + gamma_m^2)                  matrix between    (Eq. 4)
///       + P_c/p^2                                                                crossover films   (Eq. 5)
/// f_t = W0/p, f_m = w0/p, f_t gamma_t + f_m gamma_m = theta_dot (Eqs. 1-6; physics: energy model). The
/// matrix shears faster inside a tow, by 1/(1 - kappa). Shear angle in rad, 0 <= theta <= 85 degrees; angular
/// rate in rad/s, > 0.
class ShearResistance {
public:
  static constexpr int film_points = 10; ///< each way, at which a crossover's film is integrated
  static constexpr double max_angle = 85.0 * 3.14159265358979323846 / 180.0;

  /// Where the power goes, each as its share of the shear force [N/m].
  struct Parts {
    double tow = 0.0;       ///< shear inside the tows
    double inter_tow = 0.0; ///< matrix between the tows
    double crossover = 0.0; ///< matrix film between crossing tows
    [[nodiscard]] double total() const { return tow + inter_tow + crossover; }
  };

  /// `thickness` of the flat sheet [m], temperature [K]. Throws std::domain_error naming the constituent that
  /// is out of range.
  ShearResistance(const Constituents& constituents, double thickness, double temperature);

  /// N_s, split into its parts. Throws std::domain_error for an angle or rate out of range.
  [[nodiscard]] Parts parts(double theta, double rate) const;
  [[nodiscard]] double force(double theta, double rate) const { return parts(theta, rate).total(); }

  /// gamma_t [rad/s]: measured (Eqs. 2 and 6), or where p_A is least.
  [[nodiscard]] double tow_rate(double theta, double rate) const;

  /// p_A [W/m^2] when the tows shear at `tow_rate`, split into its parts.
  [[nodiscard]] Parts power(double theta, double rate, double tow_rate) const;

  /// Power dissipated in one crossover's film, P_c = integral of eta_m(|v|/t_f) |v|^2/t_f [W], when the tows
  /// shear at `tow_rate` and the sheet at `rate`: v = (tow_rate - rate) {(1+s) Y i - (1-s) X j} over a
  /// rhombus of side W0 and acute angle pi/2 - theta, s = sin theta (`printed`: 1-s in both).
  [[nodiscard]] double crossover_power(double theta, double rate, double tow_rate) const;

  [[nodiscard]] double film_thickness() const { return film_; }             ///< t_f = d_f (1/kappa - 1) [m]
  [[nodiscard]] double tow_fibre_fraction() const { return tow_fraction_; } ///< V_t = V_f p/W0

private:
  Constituents sheet_;
  double thickness_;
  IsothermalMatrix matrix_;
  double tow_share_, gap_share_; // f_t, f_m
  double tow_fraction_;          // V_t
  double closeness_;             // kappa
  double film_;                  // t_f [m]
  TowViscosityRatios ratios_;
  std::array<double, film_points> raised_x_{}; // of the points, as the matrix counts rates
};

} // namespace towform
