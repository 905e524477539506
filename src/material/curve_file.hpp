#pragma once
#include "material/shear_curves.hpp"
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// Shear curves as a text file that a person can read and evaluate: comments (#), `max_angle 75 deg`, for
/// what sheet they hold (`temperature 190 degC`, `thickness 1 mm`, both may be missing), then a line a curve:
/// rate [rad/s], fit error, a_0 ... a_11 [N/m] of N = sum a_k x^k, x = 2 theta/max_angle - 1.
struct CurveFile {
  ShearCurves curves;                ///< in rising rate, one max_angle
  std::optional<double> temperature; ///< [K]
  std::optional<double> thickness;   ///< [m]
  std::vector<std::string> notes;    ///< comment lines: where the curves come from; not read back
};

/// Throws FileError.
void write_curves(const std::filesystem::path& path, const CurveFile& file);

/// Throws InputError (code `files`) with every issue, each with its line.
CurveFile read_curves(const std::filesystem::path& path);

} // namespace towform
