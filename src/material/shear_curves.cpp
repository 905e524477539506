#include "material/shear_curves.hpp"
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace towform {

namespace {
constexpr int samples = 200;

/// Values T_0..T_11(u) of the Chebyshev polynomials.
Eigen::Matrix<double, 1, ShearCurve::order + 1> chebyshev(double u)
{
  Eigen::Matrix<double, 1, ShearCurve::order + 1> t;
  t[0] = 1.0;
  t[1] = u;
  for (int k = 2; k <= ShearCurve::order; ++k) t[k] = 2.0 * u * t[k - 1] - t[k - 2];
  return t;
}

/// Row k: the coefficients of T_k in powers.
std::array<ShearCurve::Coefficients, ShearCurve::order + 1> chebyshev_in_powers()
{
  std::array<ShearCurve::Coefficients, ShearCurve::order + 1> t{};
  t[0][0] = t[1][1] = 1.0;
  for (int k = 2; k <= ShearCurve::order; ++k)
    for (int i = 0; i <= k; ++i) t[k][i] = (i > 0 ? 2.0 * t[k - 1][i - 1] : 0.0) - t[k - 2][i];
  return t;
}
} // namespace

ShearCurve::Coefficients ShearCurve::powers() const
{
  Coefficients a{};
  const auto t = chebyshev_in_powers();
  for (int k = 0; k <= order; ++k)
    for (int i = 0; i <= k; ++i) a[i] += c_[k] * t[k][i];
  return a;
}

ShearCurve ShearCurve::from_powers(double rate, double max_angle, const Coefficients& powers,
                                   double fit_error)
{
  Coefficients rest = powers, c{};
  const auto t = chebyshev_in_powers();
  for (int k = order; k >= 0; --k) { // from the highest down: T_k alone has x^k among what is left
    c[k] = rest[k] / t[k][k];
    for (int i = 0; i <= k; ++i) rest[i] -= c[k] * t[k][i];
  }
  return {rate, max_angle, c, fit_error};
}

double ShearCurve::slope_at(double u) const
{
  double t0 = 1.0, t1 = u, d0 = 0.0, d1 = 1.0, slope = c_[1];
  for (int k = 2; k <= order; ++k) {
    const double t2 = 2.0 * u * t1 - t0, d2 = 2.0 * t1 + 2.0 * u * d1 - d0;
    slope += c_[k] * d2;
    t0 = t1;
    t1 = t2;
    d0 = d1;
    d1 = d2;
  }
  return slope;
}

double ShearCurve::slope(double theta) const
{
  return slope_at(std::min(2.0 * std::abs(theta) / max_angle_ - 1.0, 1.0)) * 2.0 / max_angle_;
}

double ShearCurves::position(double rate) const
{
  if (rate <= curves.front().rate()) return 1.0;
  for (std::size_t i = 1; i < curves.size(); ++i) {
    if (rate > curves[i].rate()) continue;
    const double low = curves[i - 1].rate();
    return static_cast<double>(i) + (rate - low) / (curves[i].rate() - low);
  }
  return static_cast<double>(curves.size());
}

int ShearCurves::next_higher(double rate) const { return static_cast<int>(std::ceil(position(rate))); }

ShearCurve fit_curve(const std::function<double(double)>& force, double rate, double max_angle)
{
  std::array<double, samples> model{};
  double largest = 0.0;
  const auto at = [](int i) { return -std::cos(M_PI * (i + 0.5) / samples); };
  for (int i = 0; i < samples; ++i) { // Chebyshev points: no weight is lost at the ends
    model[i] = force(0.5 * (at(i) + 1.0) * max_angle);
    largest = std::max(largest, std::abs(model[i]));
  }
  if (largest == 0.0) return {rate, max_angle, {}};
  Eigen::Matrix<double, Eigen::Dynamic, ShearCurve::order + 1> basis(samples, ShearCurve::order + 1);
  Eigen::VectorXd wanted(samples);
  for (int i = 0; i < samples; ++i) {
    const double scale = std::max(std::abs(model[i]), 1e-3 * largest);
    basis.row(i) = chebyshev(at(i)) / scale;
    wanted[i] = model[i] / scale;
  }
  const Eigen::Matrix<double, ShearCurve::order + 1, 1> c_fit = basis.colPivHouseholderQr().solve(wanted);
  ShearCurve::Coefficients coefficients{};
  std::copy(c_fit.data(), c_fit.data() + c_fit.size(), coefficients.begin());
  return {rate, max_angle, coefficients, (basis * c_fit - wanted).cwiseAbs().maxCoeff()};
}

ShearCurves fit_curves(const std::function<double(double, double)>& force, double rate_min, double rate_max,
                       int count, double max_angle)
{
  ShearCurves result;
  for (int c = 0; c < count; ++c) {
    const double rate = count == 1 ? rate_min : rate_min + (rate_max - rate_min) * c / (count - 1);
    result.curves.push_back(fit_curve([&](double theta) { return force(theta, rate); }, rate, max_angle));
    result.fit_error = std::max(result.fit_error, result.curves.back().fit_error());
  }
  return result;
}

} // namespace towform
