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

/// `coffin`: lubrication limit, (1 + 1/(1-kappa))/2 and 1/(1-kappa)^2.
/// `hexagonal_cell`: rigid fibres in a hexagonal array, Newtonian matrix; the transverse ratio interpolates
/// ln(eta_T) over 0.20 <= V_t <= 0.80. Throws std::domain_error outside.
TowViscosityRatios tow_viscosity_ratios(double fibre_fraction, TowViscosity model, FibrePacking packing);

/// gamma_t/theta_dot at shear angle theta [rad] from the measured tow kinematics (Eqs. 2 and 6); Eq. 6 works
/// in degrees.
double measured_tow_shear_ratio(double theta);

} // namespace towform
