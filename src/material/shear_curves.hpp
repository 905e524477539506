#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace towform {

/// One curve of the energy model's output: N_s over the shear angle at one angular rate, a polynomial of
/// order 11 (section 4 of the paper), kept in Chebyshev form on [0, max_angle], where the fit is
/// well conditioned.
class ShearCurve {
public:
  static constexpr int order = 11;
  using Coefficients = std::array<double, order + 1>;

  ShearCurve(double rate, double max_angle, const Coefficients& chebyshev, double fit_error = 0.0)
      : rate_(rate), max_angle_(max_angle), fit_error_(fit_error), c_(chebyshev), end_slope_(slope_at(1.0))
  {
  }
  /// From the coefficients a_k of sum a_k x^k, x = 2 theta/max_angle - 1 [N/m].
  static ShearCurve from_powers(double rate, double max_angle, const Coefficients& powers, double fit_error);

  [[nodiscard]] double rate() const { return rate_; }           ///< [rad/s]
  [[nodiscard]] double max_angle() const { return max_angle_; } ///< [rad]
  /// Largest |curve - what it was fitted to|, over the latter.
  [[nodiscard]] double fit_error() const { return fit_error_; }
  [[nodiscard]] Coefficients powers() const; ///< a_k of sum a_k x^k [N/m]
  /// N_s(|theta|) [N/m]; straight on beyond max_angle.
  [[nodiscard]] double force(double theta) const
  {
    const double u = 2.0 * (theta < 0.0 ? -theta : theta) / max_angle_ - 1.0, inside = u < 1.0 ? u : 1.0;
    double t0 = 1.0, t1 = inside, value = c_[0] + c_[1] * inside;
    for (int k = 2; k <= order; ++k) {
      const double t2 = 2.0 * inside * t1 - t0;
      value += c_[static_cast<std::size_t>(k)] * t2;
      t0 = t1;
      t1 = t2;
    }
    return value + end_slope_ * (u - inside);
  }
  /// dN_s/d|theta| [N/m per rad].
  [[nodiscard]] double slope(double theta) const;

private:
  [[nodiscard]] double slope_at(double u) const; // by u

  double rate_, max_angle_, fit_error_;
  Coefficients c_;
  double end_slope_; // by u, at max_angle
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

/// Fits force(theta) [N/m] at one rate by least squares of the relative error over 0 .. max_angle; where the
/// force is below a thousandth of its largest, errors are relative to that.
ShearCurve fit_curve(const std::function<double(double)>& force, double rate, double max_angle);

/// Fits `count` curves at evenly spaced rates from `rate_min` to `rate_max` (fit_curve).
ShearCurves fit_curves(const std::function<double(double, double)>& force, double rate_min, double rate_max,
                       int count, double max_angle);

} // namespace towform
