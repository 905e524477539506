#pragma once
#include <cmath>

namespace towform {

/// Tension of a yarn family per reference width, T = k (lambda - 1) (physics: yarns), with k = E h; in
/// compression the stiffness falls to `compression_factor` k, over a smooth switch of width `softness` in
/// strain.
struct YarnLaw {
  double stiffness = 0.0;          ///< k [N/m]
  double compression_factor = 0.1; ///< [-]
  static constexpr double softness = 1e-4;

  /// T(strain) [N/m].
  [[nodiscard]] double tension(double strain) const
  {
    return stiffness * (compression_factor * strain + (1.0 - compression_factor) * pull(strain));
  }
  /// dT/dstrain [N/m].
  [[nodiscard]] double slope(double strain) const
  {
    const double pulled = 0.5 * (1.0 + strain / std::hypot(strain, softness));
    return stiffness * (compression_factor + (1.0 - compression_factor) * pulled);
  }
  /// Strain energy per reference area, the integral of T [J/m^2].
  [[nodiscard]] double energy(double strain) const
  {
    const double root = std::hypot(strain, softness);
    const double pulled =
        0.5 * (0.5 * strain * (strain + root) + 0.5 * softness * softness * std::asinh(strain / softness) -
               softness * strain);
    return stiffness * (0.5 * compression_factor * strain * strain + (1.0 - compression_factor) * pulled);
  }

private:
  /// The tensile part of a strain: 0 at 0, strain - softness/2 far in tension, -softness/2 far in
  /// compression.
  static double pull(double strain)
  {
    return 0.5 * (strain + std::sqrt(strain * strain + softness * softness) - softness);
  }
};

} // namespace towform
