#pragma once

namespace towform {

/// Viscosity of the matrix [Pa s] at a local shear rate [1/s] and temperature [K].
/// Cross: eta = eta0(T) / (1 + (lambda(T) rate)^(1-n)); eta0 and lambda share the Arrhenius shift
/// exp(Ea/R (1/T - 1/Tref)).
struct MatrixViscosity {
  double zero_shear_viscosity = 0.0;  ///< eta0 at the reference temperature [Pa s]
  double time_constant = 0.0;         ///< lambda at the reference temperature [s]
  double exponent = 1.0;              ///< n, 0 < n <= 1
  double reference_temperature = 0.0; ///< [K]
  double activation_energy = 0.0;     ///< Ea [J/mol]
};

enum class TowViscosity { hexagonal_cell, coffin };
enum class FibrePacking { hexagonal, square };
enum class CrossoverField { derived, printed };

/// What the sheet is made of.
struct Constituents {
  double fibre_volume_fraction = 0.0; ///< V_f of the composite [-]
  double tow_width = 0.0;             ///< W0 [m]
  double tow_gap = 0.0;               ///< w0 [m]
  double fibre_diameter = 0.0;        ///< d_f [m]
  double weave_factor = 1.0;          ///< q [-]
  double density = 0.0;               ///< of the composite [kg/m^3]
  TowViscosity tow_viscosity = TowViscosity::hexagonal_cell;
  FibrePacking fibre_packing = FibrePacking::hexagonal;
  CrossoverField crossover_field = CrossoverField::derived;
  MatrixViscosity matrix;
};

} // namespace towform
