#pragma once
#include <vector>

namespace towform {

/// Viscosity of the matrix over the shear rate g [1/s], at the reference temperature [Pa s]; n, lambda, eta0
/// and a are the members of MatrixViscosity. At another temperature it is eta(g, T) = a_T eta(a_T g): the
/// shift acts on eta0 and lambda alike.
enum class MatrixModel {
  cross,          ///< eta0 / (1 + (lambda g)^(1-n))                       (Cross 1965)
  carreau_yasuda, ///< eta0 (1 + (lambda g)^a)^((n-1)/a)                   (Yasuda 1979; a = 2: Carreau)
  power_law,      ///< eta0 min(1, (lambda g)^(n-1)): K g^(n-1), K = eta0 lambda^(n-1), capped at eta0, that
                  ///< is, below the rate 1/lambda
  table,          ///< log-log between points; constant below the first, last segment's power law above
};

/// Shift a_T with temperature T; Tr is the reference temperature [K].
enum class TemperatureShift {
  arrhenius, ///< a_T = exp(Ea/R (1/T - 1/Tr))
  wlf,       ///< log10 a_T = -C1 (T - Tr)/(C2 + T - Tr), T > Tr - C2     (Williams, Landel, Ferry 1955)
};

struct ViscosityPoint {
  double rate = 0.0;      ///< [1/s], > 0
  double viscosity = 0.0; ///< [Pa s], > 0
};

/// The matrix's viscosity over shear rate and temperature.
struct MatrixViscosity {
  double zero_shear_viscosity = 0.0;  ///< eta0 at the reference temperature [Pa s], > 0
  double time_constant = 0.0;         ///< lambda at the reference temperature [s], >= 0
  double exponent = 1.0;              ///< n, 0 < n <= 1
  double reference_temperature = 0.0; ///< Tr [K], > 0
  double activation_energy = 0.0;     ///< Ea [J/mol], >= 0 (Arrhenius)
  MatrixModel model = MatrixModel::cross;
  TemperatureShift shift = TemperatureShift::arrhenius;
  double transition = 2.0;              ///< a of Carreau-Yasuda, > 0
  double wlf_c1 = 0.0;                  ///< C1, >= 0
  double wlf_c2 = 0.0;                  ///< C2 [K], > 0
  std::vector<ViscosityPoint> points{}; ///< of the table, two or more in rising rate
};

/// Model of a tow's viscosities; limits and equations in src/material/tow.hpp.
enum class TowViscosity { hexagonal_cell, coffin };
enum class FibrePacking { hexagonal, square };

/// Velocity between crossing tows (Eq. 5): as derived from Eq. 1 in both tows, or as the paper prints it.
enum class CrossoverField { derived, printed };

/// Where the tows' shear rate gamma_t comes from: Eqs. 2 and 6, measured on a 2x2 twill, or the gamma_t that
/// dissipates least at every (theta, theta_dot), which needs no measurement and fits any weave.
enum class TowKinematics { measured, minimum_power };

/// What the sheet is made of. One crossover a cell of pitch p = W0 + w0; the weave enters by q and p.
struct Constituents {
  double fibre_volume_fraction = 0.0; ///< V_f of the composite, > 0; V_t = V_f p/W0 below the packing limit
  double tow_width = 0.0;             ///< W0 [m], > 0
  double tow_gap = 0.0;               ///< w0 [m], >= 0
  double fibre_diameter = 0.0;        ///< d_f [m], > 0
  double weave_factor = 1.0;          ///< q, > 0: on the matrix between the tows (Eq. 4)
  double density = 0.0;               ///< of the composite [kg/m^3], > 0
  TowViscosity tow_viscosity = TowViscosity::hexagonal_cell;
  FibrePacking fibre_packing = FibrePacking::hexagonal;
  CrossoverField crossover_field = CrossoverField::derived;
  TowKinematics tow_kinematics = TowKinematics::measured;
  MatrixViscosity matrix;
};

} // namespace towform
