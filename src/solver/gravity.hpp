#pragma once
#include "towform/vec3.hpp"
#include <span>
#include <vector>

namespace towform {

/// The sheet's weight. Mass scaling does not make it heavier.
struct Gravity {
  std::vector<Vec3> weight; ///< n, own mass of a node times the acceleration [N]

  void add(std::span<Vec3> force) const
  {
    for (std::size_t n = 0; n < weight.size(); ++n) force[n] += weight[n];
  }
  /// Work done on the sheet since the start [J].
  [[nodiscard]] double work(std::span<const Vec3> start, std::span<const Vec3> position) const
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < weight.size(); ++n) sum += dot(weight[n], position[n] - start[n]);
    return sum;
  }
};

} // namespace towform
