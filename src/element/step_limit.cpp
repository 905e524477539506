#include "element/step_limit.hpp"
#include "parallel/parallel.hpp"
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace towform {

namespace {

constexpr int most_vectors = 80, few_vectors = 15;
constexpr int vectors_between_looks = 5; ///< at how near they are
constexpr double close_enough = 0.005;   ///< what may be left, over the eigenvalue

/// The same every time for a mesh.
std::vector<Vec3> random_signs(std::size_t nodes)
{
  std::uint64_t bits = 0;
  const auto sign = [&] {
    bits += 0x9e3779b97f4a7c15ULL; // splitmix64 (Steele, Lea and Flood 2014)
    std::uint64_t mixed = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
    return (mixed ^ (mixed >> 31)) >> 63 == 0 ? 1.0 : -1.0;
  };
  std::vector<Vec3> v(nodes);
  for (Vec3& x : v) x = {sign(), sign(), sign()};
  return v;
}

/// How far the largest value that Lanczos' method finds with some vectors may lie below the eigenvalue, over that, all but once in
/// a million random starts, however the eigenvalues lie (Kuczynski and Wozniakowski, SIAM J. Matrix Anal. Appl. 13 (1992)
/// 1094-1122: more with a probability of at most 1.648 sqrt(n) exp(-(2 k - 1) sqrt(share))).
double missing_share(std::size_t unknowns, std::size_t vectors)
{
  constexpr double once_in = 1e6;
  const double root = std::log(1.648 * std::sqrt(static_cast<double>(unknowns)) * once_in) / (2.0 * static_cast<double>(vectors) - 1.0);
  return root * root;
}

/// Of the sheet at its nodes.
std::vector<Vec3> node_normals(std::span<const Triangle> triangles, std::span<const Vec3> position)
{
  std::vector<Vec3> normals(position.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 twice_area = cross(position[b] - position[a], position[c] - position[a]);
    for (const int n : {a, b, c}) normals[n] += twice_area;
  }
  for (Vec3& n : normals)
    if (const double size = norm(n); size > 0.0) n *= 1.0 / size;
  return normals;
}

} // namespace

StepLimit::StepLimit(const Blank& blank, const Membrane& membrane, std::span<const double> mass, double shear_modulus,
                     std::span<const Bending> bending, const ToolSprings& springs)
    : blank_(blank), membrane_(membrane), mass_(mass), bending_(bending), shear_modulus_(shear_modulus), springs_(springs)
{
  for (const Bending& b : bending) bending_damping_time_ = std::max(bending_damping_time_, b.damping_time);
}

void StepLimit::hold_on_mirrors(std::span<Vec3> v) const
{
  for (const int n : blank_.mirror_x) v[n].x = 0.0;
  for (const int n : blank_.mirror_y) v[n].y = 0.0;
}

StepLimit::Found StepLimit::largest_frequency_squared(const LinearSheet& sheet, const Surroundings& around, double dt,
                                                      int vectors) const
{
  const double along = springs_.along + 2.0 * springs_.along_damping / dt;
  const double more = springs_.normal + 2.0 * springs_.normal_damping / dt - along;
  const std::size_t nodes = mass_.size();
  const std::span<const double> area = membrane_.node_area;
  const auto& [normals, tools] = around;
  std::vector<Vec3> now = random_signs(nodes), before(nodes); // displacements, whose products count masses
  hold_on_mirrors(now);
  std::vector<double> diagonal, beside;
  LinearForces work;
  Found result;
  double squared = 0.0;
  for (std::size_t n = 0; n < nodes; ++n) squared += mass_[n] * norm_squared(now[n]);
  double size = std::sqrt(squared);
  while (static_cast<int>(diagonal.size()) < vectors) {
    linear_forces(sheet, now, work);
    std::vector<Vec3>& next = work.force; // M^-1 K of now
    diagonal.push_back(parallel_sum(nodes, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t n = begin; n < end; ++n) {
        now[n] *= 1.0 / size;
        const Vec3 springs = along * now[n] + more * dot(normals[n], now[n]) * normals[n];
        const double touched = tools.empty() ? area[n] : tools[n] * area[n];
        const Vec3 force = touched * springs - (1.0 / size) * next[n];
        sum += dot(now[n], force);
        next[n] = (1.0 / mass_[n]) * force;
      }
      return sum;
    }));
    hold_on_mirrors(next);
    const double back = beside.empty() ? 0.0 : beside.back(), own = diagonal.back();
    const double left = std::sqrt(parallel_sum(nodes, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t n = begin; n < end; ++n) {
        next[n] -= own * now[n] + back * before[n];
        sum += mass_[n] * norm_squared(next[n]);
      }
      return sum;
    }));

    const bool last = static_cast<int>(diagonal.size()) == vectors;
    if (last || diagonal.size() % vectors_between_looks == 0 || !(left > 0.0)) {
      const auto count = static_cast<Eigen::Index>(diagonal.size());
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
      small.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), count),
                                   Eigen::Map<const Eigen::VectorXd>(beside.data(), count - 1));
      const double largest = small.eigenvalues()(count - 1);
      const double residual = left * std::abs(small.eigenvectors()(count - 1, count - 1));
      const double missing = missing_share(3 * nodes, diagonal.size());
      result = {largest, std::min(largest + residual, missing < 1.0 ? largest / (1.0 - missing) : HUGE_VAL)};
      if (residual <= close_enough * largest) break;
    }
    beside.push_back(left);
    before.swap(now);
    now.swap(next);
    size = left;
  }
  return result;
}

double StepLimit::at(std::span<const Vec3> position, std::span<const double> tools, double near) const
{
  LinearSheet sheet{membrane_, bending_, shear_modulus_, position};
  const Surroundings around{node_normals(membrane_.triangles, position), tools};
  const auto squared = [&](double counted_at, int vectors) {
    sheet.yarn_factor = 1.0 + 2.0 * membrane_.damping_time / counted_at;
    sheet.bending_factor = 1.0 + 2.0 * bending_damping_time_ / counted_at;
    return largest_frequency_squared(sheet, around, counted_at, vectors);
  };
  const bool damped = membrane_.damping_time > 0.0 || bending_damping_time_ > 0.0 || springs_.normal_damping > 0.0;
  constexpr double a_little_less = 0.97, little = 1.1;
  double counted_at = near;
  if (!(near > 0.0)) { // without damping first, roughly
    const double omega = damped ? std::sqrt(squared(HUGE_VAL, few_vectors).least) : 0.0, xi = 0.5 * membrane_.damping_time * omega;
    counted_at = damped ? a_little_less * 2.0 / omega * (std::sqrt(1.0 + xi * xi) - xi) : HUGE_VAL;
  }
  double limit = 2.0 / std::sqrt(squared(counted_at, most_vectors).most);
  const bool on_safe_side = counted_at <= limit && limit < little * counted_at; // a shorter step's damping weighs more
  if (damped && !on_safe_side) limit = 2.0 / std::sqrt(squared(a_little_less * limit, most_vectors).most);
  return limit;
}

} // namespace towform
