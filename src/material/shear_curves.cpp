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

/// sum c_k T_k(u) and its derivative by u.
std::pair<double, double> evaluate(const ShearCurve::Coefficients& c, double u)
{
  double t0 = 1.0, t1 = u, d0 = 0.0, d1 = 1.0;
  double value = c[0] + c[1] * u, slope = c[1];
  for (int k = 2; k <= ShearCurve::order; ++k) {
    const double t2 = 2.0 * u * t1 - t0, d2 = 2.0 * t1 + 2.0 * u * d1 - d0;
    value += c[k] * t2;
    slope += c[k] * d2;
    t0 = t1;
    t1 = t2;
    d0 = d1;
    d1 = d2;
  }
  return {value, slope};
}
} // namespace

double ShearCurve::force(double theta) const
{
  const double u = 2.0 * std::abs(theta) / max_angle_ - 1.0;
  const auto [value, slope] = evaluate(c_, std::min(u, 1.0));
  return u <= 1.0 ? value : value + slope * (u - 1.0);
}

double ShearCurve::slope(double theta) const
{
  const double u = std::min(2.0 * std::abs(theta) / max_angle_ - 1.0, 1.0);
  return evaluate(c_, u).second * 2.0 / max_angle_;
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

ShearCurves fit_curves(const std::function<double(double, double)>& force, double rate_min, double rate_max,
                       int count, double max_angle)
{
  ShearCurves result;
  Eigen::Matrix<double, Eigen::Dynamic, ShearCurve::order + 1> basis(samples, ShearCurve::order + 1);
  for (int c = 0; c < count; ++c) {
    const double rate = count == 1 ? rate_min : rate_min + (rate_max - rate_min) * c / (count - 1);
    std::array<double, samples> model{};
    for (int i = 0; i < samples; ++i) { // Chebyshev points: no weight is lost at the ends
      const double u = -std::cos(M_PI * (i + 0.5) / samples);
      model[i] = force(0.5 * (u + 1.0) * max_angle, rate);
      basis.row(i) = chebyshev(u) / model[i];
    }
    const Eigen::Matrix<double, ShearCurve::order + 1, 1> c_fit =
        basis.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(samples));
    ShearCurve::Coefficients coefficients{};
    std::copy(c_fit.data(), c_fit.data() + c_fit.size(), coefficients.begin());
    result.curves.emplace_back(rate, max_angle, coefficients);
    result.fit_error =
        std::max(result.fit_error, (basis * c_fit - Eigen::VectorXd::Ones(samples)).cwiseAbs().maxCoeff());
  }
  return result;
}

} // namespace towform
