#pragma once
#include "towform/energy_model.hpp"

namespace towform {

/// kappa = sqrt(V_t / F): fibre diameter over fibre spacing in a tow; F = pi/(2 sqrt 3) hexagonal, pi/4
/// square.
double fibre_closeness(double fibre_fraction, FibrePacking packing);

/// Viscosities of a tow over that of its matrix.
struct TowViscosityRatios {
  double longitudinal; ///< eta_L / eta_m: fibres sliding along each other
  double transverse;   ///< eta_T / eta_m: fibres rolling past each other
};

/// `coffin`: lubrication limit, eta_L/eta_m = (1 + 1/(1-kappa))/2, eta_T/eta_m = 1/(1-kappa)^2; 0 < kappa
/// < 1. `hexagonal_cell`: rigid fibres in a hexagonal array, Newtonian matrix, with f = V_t: eta_L/eta_m = 1
/// + 2f/(1 - f - 0.075422 f^6/(1 - 1.060283 f^12) - 0.000076 f^12); eta_T/eta_m interpolates computed values
/// (ln eta_T over f, monotone cubic), 0.20 <= V_t <= 0.80. Throws std::domain_error outside.
TowViscosityRatios tow_viscosity_ratios(double fibre_fraction, TowViscosity model, FibrePacking packing);

/// gamma_t/theta_dot = chi' sec^2 chi - tan theta tan chi at shear angle theta [rad] from the measured tow
/// kinematics (Eqs. 2 and 6): chi = 1.72e-4 t^3 - 1.72e-2 t^2 + 0.7701 t + 0.2311, chi and t = theta in
/// degrees.
double measured_tow_shear_ratio(double theta);

} // namespace towform
