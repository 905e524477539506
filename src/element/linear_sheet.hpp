#pragma once
#include "element/bending.hpp"
#include "element/membrane.hpp"
#include <span>
#include <vector>

namespace towform {

/// The sheet's stiffness at a shape, with what damping adds to it in a step: the forces of small motions about that shape. The
/// stresses that the sheet carries there are left out, as are moments that turn with it.
struct LinearSheet {
  const Membrane& membrane;
  std::span<const Bending> bending;
  double shear_modulus = 0.0;     ///< dN/dtheta [N/m]
  std::span<const Vec3> position; ///< n, the shape [m]
  double yarn_factor = 1.0;       ///< on the stiffness of strips and of bending: 1, or more where their damping is counted in
  double bending_factor = 1.0;
};

/// Room for what LinearSheet works with, and the forces.
struct LinearForces {
  std::vector<Vec3> force; ///< n, -K u [N]
  std::vector<Vec3> block_force;
};

/// f.force = -K u for `motion` u [m].
void linear_forces(const LinearSheet& sheet, std::span<const Vec3> motion, LinearForces& f);

} // namespace towform
