#pragma once
#include "material/curve_file.hpp"
#include "towform/case.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace towform {

/// Where a prediction is asked for.
struct PredictionPoints {
  std::vector<double> temperatures{};        ///< [K]; the case's own when empty
  std::vector<double> rates{0.1, 1.0, 10.0}; ///< [rad/s], > 0
  std::vector<double> angles{};              ///< [rad], 0 .. 85 degrees
};

/// The energy model's curves for a case (its curve_rate_min .. curve_count), with their inputs as notes.
/// All three throw InputError when a constituent, an angle or a rate is out of range, or when the case's
/// material has curves or a shear_tangent instead of constituents.
CurveFile predicted_curves(const Case& c);

/// The prediction to read: shear force over angle at the rates, its parts at the middle one, the cell's
/// geometry, and the fit error of every curve.
std::string prediction_text(const Case& c, const CurveFile& curves, const PredictionPoints& points);

/// CSV, a line a temperature, rate and angle: temperature_degC,rate_rad_per_s,theta_deg,shear_force_N_per_m,
/// tow,inter_tow,crossover (the last three in N/m, their sum the shear force).
std::string prediction_table(const Case& c, const PredictionPoints& points);

} // namespace towform
