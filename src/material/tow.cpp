#include "material/tow.hpp"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace towform {

namespace {
using std::numbers::pi;

// Transverse shear of a hexagonal array, eta_T/eta_m over fibre fraction (physics: energy model).
constexpr std::array<double, 10> cell_fraction{0.20, 0.35, 0.40, 0.50, 0.55, 0.60, 0.65, 0.70, 0.75, 0.80};
constexpr std::array<double, 10> cell_ratio{1.5055, 2.1711, 2.5238, 3.6613, 4.6255,
                                            6.0980, 8.4898, 12.714, 21.149, 41.82};

/// Slope of a monotone piecewise cubic at an end, from the first two secants (Fritsch-Carlson, three-point
/// form).
double end_slope(double h0, double h1, double d0, double d1)
{
  const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.0) return 0.0;
  if (d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0)) return 3.0 * d0;
  return slope;
}

/// Monotone piecewise cubic interpolation (PCHIP) of ln(cell_ratio) over cell_fraction.
double cell_transverse_ratio(double f)
{
  constexpr std::size_t n = cell_fraction.size();
  std::array<double, n - 1> h{}, secant{};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = cell_fraction[i + 1] - cell_fraction[i];
    secant[i] = std::log(cell_ratio[i + 1] / cell_ratio[i]) / h[i];
  }
  std::array<double, n> slope{};
  slope.front() = end_slope(h[0], h[1], secant[0], secant[1]);
  slope.back() = end_slope(h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
  for (std::size_t i = 1; i + 1 < n; ++i) { // weighted harmonic mean; all secants are positive here
    const double w0 = 2.0 * h[i] + h[i - 1], w1 = h[i] + 2.0 * h[i - 1];
    slope[i] = (w0 + w1) / (w0 / secant[i - 1] + w1 / secant[i]);
  }
  std::size_t i = 0;
  while (i + 2 < n && f > cell_fraction[i + 1]) ++i;
  const double t = (f - cell_fraction[i]) / h[i];
  const double a = std::log(cell_ratio[i]), b = std::log(cell_ratio[i + 1]);
  const double value = a * (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) + b * t * t * (3.0 - 2.0 * t) +
                       h[i] * t * (1.0 - t) * (slope[i] * (1.0 - t) - slope[i + 1] * t);
  return std::exp(value);
}

double cell_longitudinal_ratio(double f)
{
  const double f6 = std::pow(f, 6), f12 = f6 * f6;
  return 1.0 + 2.0 * f / (1.0 - f - 0.075422 * f6 / (1.0 - 1.060283 * f12) - 0.000076 * f12);
}
} // namespace

double fibre_closeness(double fibre_fraction, FibrePacking packing)
{
  const double limit = packing == FibrePacking::hexagonal ? pi / (2.0 * std::numbers::sqrt3) : pi / 4.0;
  return std::sqrt(fibre_fraction / limit);
}

TowViscosityRatios tow_viscosity_ratios(double fibre_fraction, TowViscosity model, FibrePacking packing)
{
  if (model == TowViscosity::coffin) {
    const double gap = 1.0 - fibre_closeness(fibre_fraction, packing);
    return {0.5 * (1.0 + 1.0 / gap), 1.0 / (gap * gap)};
  }
  if (fibre_fraction < cell_fraction.front() || fibre_fraction > cell_fraction.back())
    throw std::domain_error(
        fmt::format("the fibre fraction inside a tow is {:.3f}, outside the {} to {} of the "
                    "hexagonal-cell viscosities; tow_viscosity = \"coffin\" has no such limit",
                    fibre_fraction, cell_fraction.front(), cell_fraction.back()));
  return {cell_longitudinal_ratio(fibre_fraction), cell_transverse_ratio(fibre_fraction)};
}

double measured_tow_shear_ratio(double theta)
{
  const double degree = pi / 180.0, t = theta / degree;
  const double chi = (((1.72e-4 * t - 1.72e-2) * t + 0.7701) * t + 0.2311) * degree;
  const double chi_slope = (3.0 * 1.72e-4 * t - 2.0 * 1.72e-2) * t + 0.7701;
  const double cosine = std::cos(chi);
  return chi_slope / (cosine * cosine) - std::tan(theta) * std::tan(chi);
}

} // namespace towform
