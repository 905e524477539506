#pragma once
#include "towform/vec3.hpp"
#include <cstdint>
#include <vector>

namespace towform {

/// What a fabric law remembers at a point between steps.
struct ShearPoint {
  double angle = 0.0; ///< theta [rad], as of the last update
  double force = 0.0; ///< N [N/m], conjugate to sin(theta)
  double rate = 0.0;  ///< |theta_dot| as the law sees it [rad/s]
};

/// A quantity of the two yarn families.
struct YarnPair {
  double warp = 0.0, weft = 0.0;
};

/// Everything of the sheet that changes with time. Positions stand at step n, velocities at n - 1/2 (central
/// differences). Sizes: n nodes, m elements.
struct State {
  double time = 0.0;     ///< t_n [s]
  std::int64_t step = 0; ///< n
  double last_dt = 0.0;  ///< t_n - t_(n-1) [s]

  std::vector<Vec3> position; ///< n, x_n [m]
  std::vector<Vec3> velocity; ///< n, v_(n-1/2) [m/s]
  std::vector<Vec3> force;    ///< n, at x_n [N]

  std::vector<double> strip_strain; ///< per strip of yarn, mean over its entries, at x_n
  std::vector<double> sine;         ///< m, sin(theta) = f1.f2 at x_n
  std::vector<double> shear_angle;  ///< m, of ShearPoint at x_n [rad]
  std::vector<double> shear_force;  ///< m, likewise [N/m]
  std::vector<double> shear_rate;   ///< m, likewise [rad/s]
  std::vector<Vec3> block_force;    ///< of blocks on nodes that several reach: the membrane's, then those of bending [N]

  // Since the start, per block of elements or node, so that sums are the same for any number of threads [J]
  std::vector<double> shear_work;       ///< per block, done on the sheet in shear
  std::vector<double> shear_dissipated; ///< per block
  std::vector<double> yarn_damping;     ///< per block
  std::vector<double> mass_damping;     ///< n, or empty without it
};

} // namespace towform
