#pragma once
#include "towform/material.hpp"
#include <algorithm>
#include <cmath>
#include <vector>

namespace towform {

/// Bending moment of a yarn family per width of the sheet over its curvature, elastic and odd: linear,
/// M = B kappa, or straight lines between the points of a table from (0, 0) on, the last one continued.
class MomentLaw {
public:
  /// `stiffness` B [N m]: moment per width over curvature.
  explicit MomentLaw(double stiffness) : slope_{stiffness} {}
  explicit MomentLaw(const std::vector<BendingPoint>& table)
  {
    for (const BendingPoint& p : table) {
      const BendingPoint& last = corner_.back();
      slope_.push_back((p.moment - last.moment) / (p.curvature - last.curvature));
      energy_.push_back(energy_.back() + 0.5 * (last.moment + p.moment) * (p.curvature - last.curvature));
      corner_.push_back(p);
    }
    corner_.pop_back(); // the last line goes on
    energy_.pop_back();
  }

  /// One line through the origin.
  [[nodiscard]] bool is_straight() const { return slope_.size() == 1; }
  /// M [N].
  [[nodiscard]] double moment(double curvature) const
  {
    if (is_straight()) return slope_.front() * curvature;
    const std::size_t i = line(std::abs(curvature));
    return std::copysign(corner_[i].moment + slope_[i] * (std::abs(curvature) - corner_[i].curvature),
                         curvature);
  }
  /// Energy per area, the integral of M [J/m^2].
  [[nodiscard]] double energy(double curvature) const
  {
    const double size = std::abs(curvature);
    const std::size_t i = line(size);
    const double beyond = size - corner_[i].curvature;
    return energy_[i] + corner_[i].moment * beyond + 0.5 * slope_[i] * beyond * beyond;
  }
  /// Largest dM/dkappa [N m].
  [[nodiscard]] double stiffness() const { return *std::max_element(slope_.begin(), slope_.end()); }

private:
  [[nodiscard]] std::size_t line(double size) const
  {
    std::size_t i = 0;
    while (i + 1 < corner_.size() && size > corner_[i + 1].curvature) ++i;
    return i;
  }

  std::vector<BendingPoint> corner_{{0.0, 0.0}}; ///< where each line starts
  std::vector<double> energy_{0.0};              ///< there [J/m^2]
  std::vector<double> slope_;                    ///< of each line [N m]
};

} // namespace towform
