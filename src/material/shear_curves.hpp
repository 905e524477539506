#pragma once
#include <array>
#include <functional>
#include <vector>

namespace towform {

/// One curve of the energy model's output: N_s over the shear angle at one angular rate, a polynomial of
/// order 11 (Eq. 6 ff. of the paper, section 4), kept in Chebyshev form on [0, max_angle], where the fit is
/// well conditioned.
class ShearCurve {
public:
  static constexpr int order = 11;
  using Coefficients = std::array<double, order + 1>;

  ShearCurve(double rate, double max_angle, const Coefficients& chebyshev)
      : rate_(rate), max_angle_(max_angle), c_(chebyshev)
  {
  }

  [[nodiscard]] double rate() const { return rate_; } ///< [rad/s]
  /// N_s(|theta|) [N/m]; straight on beyond max_angle.
  [[nodiscard]] double force(double theta) const;
  /// dN_s/d|theta| [N/m per rad].
  [[nodiscard]] double slope(double theta) const;

private:
  double rate_, max_angle_;
  Coefficients c_;
};

/// The curves of a sheet, in ascending rate, and how well they fit.
struct ShearCurves {
  std::vector<ShearCurve> curves;
  double fit_error = 0.0; ///< largest |curve - model| / model over all fitted points

  /// Continuous position of a rate among the curves, 1-based: 2.5 is half-way from the second to the third;
  /// not below 1 nor above the number of curves.
  [[nodiscard]] double position(double rate) const;
  /// 1-based number of the curve whose rate is next above (the last beyond it): what the paper plots.
  [[nodiscard]] int next_higher(double rate) const;
};

/// Fits `count` curves at evenly spaced rates from `rate_min` to `rate_max` by least squares of the relative
/// error over 0 .. max_angle.
ShearCurves fit_curves(const std::function<double(double, double)>& force, double rate_min, double rate_max,
                       int count, double max_angle);

} // namespace towform
