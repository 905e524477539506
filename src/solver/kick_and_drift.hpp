#pragma once
#include "towform/vec3.hpp"
#include <cstddef>
#include <span>

namespace towform {

/// Nodes that move: all of one length.
struct MovingNodes {
  std::span<Vec3> position;      ///< [m]
  std::span<Vec3> velocity;      ///< [m/s]
  std::span<const Vec3> force;   ///< [N]
  std::span<const double> mass;  ///< [kg]

  [[nodiscard]] MovingNodes part(std::size_t begin, std::size_t end) const
  {
    const std::size_t count = end - begin;
    return {position.subspan(begin, count), velocity.subspan(begin, count), force.subspan(begin, count),
            mass.subspan(begin, count)};
  }
};

/// Central differences without drag: velocities get `kick` [s] of their force over mass, positions dt of the new velocity. Returns the
/// largest square of a speed [m^2/s^2]; infinite once one is not finite.
double kick_and_drift(const MovingNodes& nodes, double kick, double dt);

} // namespace towform
