#include "element/moment_balance.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace towform {

namespace {

/// The contour integral as weights on the nodes. A quadratic's slope is straight along an edge, so that the
/// trapezoid rule with the slopes of the fits at its ends is exact.
Eigen::VectorXd contour_integral(const MirroredSheet& sheet, const SurfaceMesh& flat,
                                 std::span<const QuadraticFit> fits, const Vec3& f)
{
  std::map<std::pair<int, int>, std::pair<int, int>> edges; // those of one triangle only, in its order
  for (const Triangle& t : flat.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const auto [at, is_new] = edges.try_emplace(std::minmax(a, b), a, b);
      if (!is_new) edges.erase(at);
    }
  Eigen::VectorXd integral = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(sheet.nodes));
  for (const auto& [key, edge] : edges) {
    const Vec3 along = flat.points[edge.second] - flat.points[edge.first];
    const double across = along.y * f.x - along.x * f.y; // outward normal . f, times the length
    for (const int n : {edge.first, edge.second})
      for (std::size_t i = 0; i < fits[n].points.size(); ++i)
        integral[sheet.source(fits[n].points[i])] +=
            0.5 * across * (f.x * fits[n].weights[i].x + f.y * fits[n].weights[i].y);
  }
  return integral;
}

/// Changes of weights that keep quadratics exact, driven by one multiplier a node: change = Q (multipliers
/// of the patch) / r^4, where Q takes out what a quadratic explains.
class Changes {
public:
  Changes(const MirroredSheet& sheet, std::span<const QuadraticFit> fits) : sheet_(sheet), fits_(fits)
  {
    std::map<std::vector<std::int32_t>, int> known;
    basis_of_.reserve(fits.size());
    for (const QuadraticFit& fit : fits) {
      const auto [at, is_new] = known.try_emplace(shape(fit), static_cast<int>(basis_.size()));
      basis_of_.push_back(at->second);
      if (is_new) basis_.push_back(basis(fit));
      if (known.size() > most_known) known.clear();
    }
  }

  [[nodiscard]] Eigen::VectorXd of(std::size_t n, const Eigen::VectorXd& multiplier) const
  {
    const QuadraticFit& fit = fits_[n];
    Eigen::VectorXd v(static_cast<Eigen::Index>(fit.points.size()));
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = multiplier[sheet_.source(fit.points[i])];
    const Eigen::MatrixXd& basis = basis_of(n);
    v -= basis * (basis.transpose() * v).eval();
    return v / std::pow(fit.radius, 4);
  }

  /// Largest weight of a point on its own change, for a preconditioner.
  [[nodiscard]] double own(std::size_t n, Eigen::Index i) const
  {
    return std::max(1.0 - basis_of(n).row(i).squaredNorm(), 0.0) / std::pow(fits_[n].radius, 4);
  }

private:
  static constexpr std::size_t most_known = 1000; ///< shapes; a mesh without repetition has one a node

  [[nodiscard]] const Eigen::MatrixXd& basis_of(std::size_t n) const
  {
    return basis_[static_cast<std::size_t>(basis_of_[n])];
  }
  /// Place of a patch's point, over its radius.
  [[nodiscard]] Vec3 place(const QuadraticFit& fit, std::size_t i) const
  {
    return (1.0 / fit.radius) * (sheet_.points[fit.points[i]] - sheet_.points[fit.points[0]]);
  }
  /// The same for patches that are alike but for rounding.
  [[nodiscard]] std::vector<std::int32_t> shape(const QuadraticFit& fit) const
  {
    constexpr double fineness = 1e9;
    std::vector<std::int32_t> places;
    places.reserve(2 * fit.points.size());
    for (std::size_t i = 0; i < fit.points.size(); ++i) {
      const Vec3 d = place(fit, i);
      for (const double x : {d.x, d.y}) places.push_back(static_cast<std::int32_t>(std::lround(fineness * x)));
    }
    return places;
  }
  [[nodiscard]] Eigen::MatrixXd basis(const QuadraticFit& fit) const
  {
    const auto count = static_cast<Eigen::Index>(fit.points.size());
    Eigen::MatrixXd polynomials(count, 6);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Vec3 d = place(fit, static_cast<std::size_t>(i));
      polynomials.row(i) << 1.0, d.x, d.y, d.x * d.x, d.x * d.y, d.y * d.y;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(polynomials);
    return qr.householderQ() * Eigen::MatrixXd::Identity(count, 6);
  }

  const MirroredSheet& sheet_;
  std::span<const QuadraticFit> fits_;
  std::vector<Eigen::MatrixXd> basis_; ///< orthonormal, of the quadratics on patches of a shape
  std::vector<int> basis_of_;          ///< n
};

} // namespace

double balance_moments(const MirroredSheet& sheet, const SurfaceMesh& flat,
                       std::span<const QuadraticFit> fits, std::span<const double> area,
                       const Vec3& direction, int iterations, DirectionalWeights& weights)
{
  const auto nodes = static_cast<Eigen::Index>(sheet.nodes);
  const Changes changes(sheet, fits);
  Eigen::VectorXd imbalance = contour_integral(sheet, flat, fits, direction);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(nodes);
  double size = 0.0;
  for (std::size_t n = 0; n < sheet.nodes; ++n)
    for (std::size_t i = 0; i < fits[n].points.size(); ++i) {
      const int source = sheet.source(fits[n].points[i]);
      imbalance[source] -= area[n] * weights[n][i];
      diagonal[source] += area[n] * changes.own(n, static_cast<Eigen::Index>(i));
      size = std::max(size, std::abs(area[n] * weights[n][i]));
    }
  const double at_start = imbalance.lpNorm<Eigen::Infinity>();
  constexpr double rounding = 1e-10;
  if (at_start <= rounding * size) return 0.0;
  diagonal = diagonal.cwiseMax(1e-12 * diagonal.maxCoeff());

  const auto apply = [&](const Eigen::VectorXd& multiplier) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(nodes);
    for (std::size_t n = 0; n < sheet.nodes; ++n) {
      const Eigen::VectorXd change = changes.of(n, multiplier);
      for (Eigen::Index i = 0; i < change.size(); ++i)
        sum[sheet.source(fits[n].points[i])] += area[n] * change[i];
    }
    return sum;
  };
  Eigen::VectorXd multiplier = Eigen::VectorXd::Zero(nodes);
  Eigen::VectorXd scaled = imbalance.cwiseQuotient(diagonal), search = scaled;
  double product = imbalance.dot(scaled);
  for (int k = 0; k < iterations && imbalance.lpNorm<Eigen::Infinity>() > rounding * size; ++k) {
    const Eigen::VectorXd applied = apply(search);
    const double step = product / search.dot(applied);
    multiplier += step * search;
    imbalance -= step * applied;
    scaled = imbalance.cwiseQuotient(diagonal);
    const double next = imbalance.dot(scaled);
    search = scaled + (next / product) * search;
    product = next;
  }
  for (std::size_t n = 0; n < sheet.nodes; ++n) {
    const Eigen::VectorXd change = changes.of(n, multiplier);
    for (Eigen::Index i = 0; i < change.size(); ++i) weights[n][static_cast<std::size_t>(i)] += change[i];
  }
  return imbalance.lpNorm<Eigen::Infinity>() / at_start;
}

} // namespace towform
