#pragma once
#include "material/tow.hpp"
#include "material/viscosity.hpp"
#include "towform/energy_model.hpp"

namespace towform {

/// The unit-cell energy model at one temperature: shear force per unit length of a sheet from its
/// constituents (Eqs. 1-6; physics: energy model). Shear angle in rad, 0 <= theta <= 85 degrees; angular rate
/// in rad/s, > 0.
class ShearResistance {
public:
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

  /// N_s = p_A / (theta_dot cos theta), split into its parts.
  [[nodiscard]] Parts parts(double theta, double rate) const;
  [[nodiscard]] double force(double theta, double rate) const { return parts(theta, rate).total(); }

  /// Power dissipated in one crossover's film, P_c [W], when the tows shear at `tow_rate` and the sheet at
  /// `rate`.
  [[nodiscard]] double crossover_power(double theta, double rate, double tow_rate) const;

  [[nodiscard]] double film_thickness() const { return film_; }
  [[nodiscard]] double tow_fibre_fraction() const { return tow_fraction_; }

private:
  Constituents sheet_;
  double thickness_;
  IsothermalMatrix matrix_;
  double tow_share_, gap_share_; // f_t, f_m
  double tow_fraction_;          // V_t
  double closeness_;             // kappa
  double film_;                  // t_f [m]
  TowViscosityRatios ratios_;
};

} // namespace towform
