#pragma once
#include "material/curve_file.hpp"
#include "towform/material.hpp"
#include <functional>
#include <vector>

namespace towform {

/// N_s(theta, rate) [N/m] of shear curves: at every angle a RateLine through the curves' forces, Newtonian
/// below the lowest rate, power law above the highest.
std::function<double(double, double)> surface_of(const ShearCurves& curves);

/// The curves of `material.curves`. Throws InputError: code `files` when the file is bad, `case_file` when it
/// says it is for another temperature (by over 0.5 K) or thickness (by over 1 %) than the case's.
ShearCurves curves_of(const MaterialParameters& material, double thickness);

/// N(theta) [N/m] of a sheet whose tangent G12 = sum c_k gamma^k [Pa] over the shear angle gamma [rad] is
/// known: h times its integral from 0; a negative tangent counts as zero, so that N never falls.
class TangentForce {
public:
  TangentForce(const std::vector<double>& tangent, double thickness, double max_angle);
  [[nodiscard]] double operator()(double theta) const;

private:
  static constexpr int cells = 2000;
  std::vector<double> forces_; ///< at cells + 1 even angles
  double max_angle_;
};

} // namespace towform
