#include "material/shear_test.hpp"
#include "case/float_traps.hpp"
#include "material/rate_line.hpp"
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <stdexcept>

namespace towform {

namespace {

constexpr int fewest_points = 5;

/// A length over which cos(pi/4 - theta/2) = cos(pi/4) + displacement/reach, in both tests.
double reach(const ShearTest& test)
{
  return test.kind == ShearTest::Kind::picture_frame ? 2.0 * test.side : M_SQRT2 * (test.length - test.width);
}

/// T_k(2 theta/max_angle - 1).
double basis(int k, double theta, double max_angle)
{
  return std::cos(k * std::acos(std::clamp(2.0 * theta / max_angle - 1.0, -1.0, 1.0)));
}

struct Polynomial {
  Eigen::VectorXd coefficients;
  double max_angle = 0.0;
  int order = 0;
  double residual = 0.0; ///< root mean square over the largest force

  [[nodiscard]] double operator()(double theta) const
  {
    double value = 0.0;
    for (int k = 0; k < coefficients.size(); ++k) value += coefficients[k] * basis(k, theta, max_angle);
    return value;
  }
};

/// How much faster or slower the half-sheared regions are than a run's own rate at their angle changes their
/// N: N(theta/2, rate there)/N_run(theta/2).
using HalfFactor = std::function<double(double angle)>;

/// Least squares of one run's force; the order is that with the least error on points left out (PRESS).
Polynomial fit_run(const ShearTest& test, const TestRun& run, double max_angle, const HalfFactor& half_factor)
{
  const auto n = static_cast<Eigen::Index>(run.angle.size());
  const int highest = static_cast<int>(std::min<Eigen::Index>(ShearCurve::order, (n - 1) / 2));
  const double most = *std::max_element(run.force.begin(), run.force.end());
  Eigen::MatrixXd rows(n, highest + 1);
  Eigen::VectorXd wanted(n), weight(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double theta = run.angle[i], factor = test.weights(theta).half > 0.0 ? half_factor(theta) : 0.0;
    weight[i] = 1.0 / std::max(std::abs(run.force[i]), 0.02 * most);
    wanted[i] = run.force[i] * weight[i];
    for (int k = 0; k <= highest; ++k)
      rows(i, k) = weight[i] *
                   test.force(theta, basis(k, theta, max_angle), factor * basis(k, 0.5 * theta, max_angle));
  }
  Polynomial best;
  double least = std::numeric_limits<double>::infinity();
  for (int order = 1; order <= highest; ++order) {
    const Eigen::MatrixXd a = rows.leftCols(order + 1);
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(a);
    const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(n, order + 1);
    const Eigen::VectorXd solution = qr.solve(wanted), error = a * solution - wanted;
    double press = 0.0;
    for (Eigen::Index i = 0; i < n; ++i)
      press += std::pow(error[i] / std::max(1.0 - q.row(i).squaredNorm(), 1e-6), 2);
    if (!solution.allFinite() || press >= least) continue;
    least = press;
    best = {solution, max_angle, order,
            error.cwiseQuotient(weight).norm() / (most * std::sqrt(static_cast<double>(n)))};
  }
  if (best.order == 0) throw std::domain_error("a run's points are at too few different angles");
  return best;
}

/// The run's shear rate at an angle [rad/s].
double rate_at(const ShearTest& test, const TestRun& run, double theta)
{
  return run.rate ? *run.rate : *run.speed / test.lever(theta);
}

/// The rate of a run's curve: its angle over its time.
double mean_rate(const ShearTest& test, const TestRun& run, double max_angle)
{
  return run.rate ? *run.rate : max_angle * *run.speed / test.displacement(max_angle);
}

} // namespace

double ShearTest::angle(double displacement) const
{
  const UntrappedFloats not_a_number_when_out_of_reach;
  return M_PI_2 - 2.0 * std::acos(M_SQRT1_2 + displacement / reach(*this));
}

double ShearTest::displacement(double angle) const
{
  return reach(*this) * (std::cos(M_PI_4 - 0.5 * angle) - M_SQRT1_2);
}

double ShearTest::lever(double angle) const { return 0.5 * reach(*this) * std::sin(M_PI_4 - 0.5 * angle); }

ShearTest::Weights ShearTest::weights(double angle) const
{
  if (kind == Kind::picture_frame) return {side * side * std::cos(angle), 0.0};
  // A strip of L x W with yarns at +-45 degrees: a triangle of W^2/4 at either grip moves with it, the four
  // bordering regions of W^2/4 each have one yarn family held by a grip, what is left shears fully.
  const double full_area = width * (length - 1.5 * width), half_area = width * width;
  return {full_area * std::cos(angle), 0.5 * half_area * std::cos(0.5 * angle)};
}

double ShearTest::force(double angle, double full, double half) const
{
  const Weights w = weights(angle);
  return (w.full * full + w.half * half) / lever(angle);
}

FittedTest fit_test(const ShearTest& test, const std::vector<TestRun>& runs)
{
  FittedTest result;
  result.rate_min = std::numeric_limits<double>::infinity();
  std::vector<double> reached;
  double common = std::numeric_limits<double>::infinity();
  for (const TestRun& run : runs) {
    if (run.angle.size() < fewest_points)
      throw std::domain_error(
          fmt::format("a run has {} points; it needs {} or more", run.angle.size(), fewest_points));
    const auto [low, high] = std::minmax_element(run.angle.begin(), run.angle.end());
    reached.push_back(*high);
    if (*high - *low < 1e-3) throw std::domain_error("a run's points are all at one angle");
    if (*std::max_element(run.force.begin(), run.force.end()) <= 0.0)
      throw std::domain_error("a run's force is nowhere positive");
    common = std::min(common, *high);
    for (const double theta : {*low, *high}) {
      result.rate_min = std::min(result.rate_min, rate_at(test, run, theta));
      result.rate_max = std::max(result.rate_max, rate_at(test, run, theta));
    }
  }

  std::vector<Polynomial> fits(runs.size());
  const auto force_at = [&](double theta, double rate) {
    std::vector<std::pair<double, double>> points;
    double most = 0.0;
    for (std::size_t j = 0; j < runs.size(); ++j) {
      points.emplace_back(rate_at(test, runs[j], theta), fits[j](theta));
      most = std::max(most, points.back().second);
    }
    if (!(most > 0.0)) return 0.0; // the fit of a force that starts from nothing
    std::sort(points.begin(), points.end());
    std::vector<double> rates, forces;
    for (const auto& [r, f] : points) {
      rates.push_back(r);
      forces.push_back(f);
    }
    return RateLine(rates, forces, 1e-6 * most, RateLine::Below::first_segment).force(rate);
  };
  // How N depends on the rate is needed in the half-sheared regions before it is known; a few rounds settle
  // it.
  const bool repeated = test.kind == ShearTest::Kind::bias_extension && runs.size() > 1;
  for (int round = 0; round < (repeated ? 12 : 1); ++round) {
    std::vector<Polynomial> next;
    for (std::size_t j = 0; j < runs.size(); ++j) {
      const auto half_factor = [&](double theta) {
        const double own = round == 0 ? 0.0 : fits[j](0.5 * theta);
        return own > 0.0 ? force_at(0.5 * theta, 0.5 * rate_at(test, runs[j], theta)) / own : 1.0;
      };
      next.push_back(fit_run(test, runs[j], reached[j], half_factor));
    }
    fits = std::move(next);
  }
  std::vector<std::pair<double, std::size_t>> by_rate;
  for (std::size_t j = 0; j < runs.size(); ++j) by_rate.emplace_back(mean_rate(test, runs[j], common), j);
  std::sort(by_rate.begin(), by_rate.end());
  for (const auto& [rate, j] : by_rate) {
    const auto curve = [&, rate = rate, j = j](double theta) {
      return std::max(runs.size() == 1 ? fits[j](theta) : force_at(theta, rate), 0.0);
    };
    result.curves.curves.push_back(fit_curve(curve, rate, common));
    result.curves.fit_error = std::max(result.curves.fit_error, result.curves.curves.back().fit_error());
    result.orders.push_back(fits[j].order);
    result.residuals.push_back(fits[j].residual);
  }
  return result;
}

} // namespace towform
