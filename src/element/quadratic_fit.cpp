#include "element/quadratic_fit.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace towform {

namespace {

/// Smallest over largest singular value below which a patch determines a quadratic poorly, or not at all.
constexpr double good_condition = 0.01, least_condition = 1e-6;

double radius_of(const MirroredSheet& sheet, const std::vector<int>& patch)
{
  double squared = 0.0;
  for (const int p : patch)
    squared = std::max(squared, norm_squared(sheet.points[p] - sheet.points[patch.front()]));
  return std::sqrt(squared);
}

/// For every neighbour another one straight across?
bool is_symmetric(const MirroredSheet& sheet, const std::vector<int>& patch)
{
  const Vec3 middle = sheet.points[patch.front()];
  const double near = 1e-6 * radius_of(sheet, patch);
  return std::all_of(patch.begin() + 1, patch.end(), [&](int p) {
    const Vec3 across = 2.0 * middle - sheet.points[p];
    return std::any_of(patch.begin() + 1, patch.end(),
                       [&](int q) { return norm(sheet.points[q] - across) < near; });
  });
}

using Polynomials = Eigen::Matrix<double, Eigen::Dynamic, 6>;
using Square = Eigen::Matrix<double, 6, 6>;

/// Whether the smallest over the largest singular value of a triangular matrix is as large.
bool is_conditioned(const Square& r, double condition)
{
  if (!((r.diagonal().array() != 0.0).all())) return false;
  const Square inverse = r.triangularView<Eigen::Upper>().solve(Square::Identity());
  if (condition * r.norm() * inverse.norm() <= 1.0) return true; // which mostly settles it
  const Eigen::JacobiSVD<Square> svd(r);
  return svd.singularValues()[5] >= condition * svd.singularValues()[0];
}

QuadraticFit fit(const MirroredSheet& sheet, const std::vector<int>& patch, double condition)
{
  const auto count = static_cast<Eigen::Index>(patch.size());
  const double h = radius_of(sheet, patch);
  Polynomials polynomials(count, 6);
  Eigen::VectorXd weight(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 d = (1.0 / h) * (sheet.points[patch[i]] - sheet.points[patch.front()]);
    // Like an inverse square, so that the second ring only supports the first; capped at the node itself.
    constexpr double nearest = 0.3;
    const double distance = std::max(norm(d), nearest);
    weight[i] = 1.0 / (distance * distance);
    polynomials.row(i) << 1.0, d.x, d.y, 0.5 * d.x * d.x, d.x * d.y, 0.5 * d.y * d.y;
  }
  if (count < 6) return {};
  const Eigen::HouseholderQR<Polynomials> qr(weight.asDiagonal() * polynomials);
  const Square r = qr.matrixQR().topRows<6>().triangularView<Eigen::Upper>();
  if (!is_conditioned(r, condition)) return {};
  Eigen::MatrixXd weights = weight.asDiagonal();
  weights.applyOnTheLeft(qr.householderQ().transpose());
  weights = r.triangularView<Eigen::Upper>().solve(weights.topRows<6>()).eval();
  QuadraticFit result{patch, {}, h};
  for (Eigen::Index i = 0; i < count; ++i)
    result.weights.push_back({weights(1, i) / h, weights(2, i) / h, weights(3, i) / (h * h),
                              weights(4, i) / (h * h), weights(5, i) / (h * h)});
  return result;
}

} // namespace

QuadraticFit quadratic_fit(const MirroredSheet& sheet, int node)
{
  std::vector<int> patch{node};
  const std::vector<int>& ring = sheet.neighbours[node];
  patch.insert(patch.end(), ring.begin(), ring.end());
  constexpr std::size_t enough = 7, plenty = 9; // a quadratic has six coefficients
  if (patch.size() >= enough && is_symmetric(sheet, patch))
    if (QuadraticFit result = fit(sheet, patch, good_condition); !result.points.empty()) return result;

  // Of the second ring first those that fill the gaps of the first: neighbours of two of its nodes.
  std::vector<int> second;
  for (const int i : ring)
    for (const int j : sheet.neighbours[i])
      if (std::find(patch.begin(), patch.end(), j) == patch.end()) second.push_back(j);
  std::sort(second.begin(), second.end());
  std::vector<int> gaps, others;
  for (std::size_t i = 0; i < second.size();) {
    const auto next =
        static_cast<std::size_t>(std::upper_bound(second.begin(), second.end(), second[i]) - second.begin());
    (next - i > 1 ? gaps : others).push_back(second[i]);
    i = next;
  }
  for (const std::vector<int>& more : {gaps, others}) {
    patch.insert(patch.end(), more.begin(), more.end());
    if (patch.size() < plenty) continue;
    if (QuadraticFit result = fit(sheet, patch, good_condition); !result.points.empty()) return result;
  }
  return fit(sheet, patch, least_condition);
}

} // namespace towform
