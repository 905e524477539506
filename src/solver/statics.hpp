#pragma once
#include "element/quadrilateral.hpp"
#include "solver/statics_constraints.hpp"
#include "towform/motion.hpp"
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// Held nodes that move together, or stand.
struct HeldGroup {
  std::string name; ///< empty: not reported
  Vec3 direction;   ///< unit, of the motion and of the reported force
  std::optional<Motion> motion;
};

/// A quasi-static problem in the plane of the flat sheet: z does not move, which a specimen clamped all round
/// its plane allows until it wrinkles. Inertia, yarn damping and contact do not exist.
struct StaticsModel {
  std::vector<Vec3> reference; ///< n [m]
  QuadrilateralMembrane membrane;
  LinearConstraints constraints;
  std::vector<HeldGroup> groups;
};

/// The equilibrium at t_n. Sizes: n nodes, m elements, h held nodes.
struct StaticsState {
  double time = 0.0;     ///< t_n [s]
  std::int64_t step = 0; ///< increments so far
  double last_dt = 0.0;  ///< t_n - t_(n-1) [s]

  std::vector<Vec3> position;      ///< n [m]
  std::vector<Vec3> velocity;      ///< n, mean over the last increment [m/s]
  std::vector<ShearPoint> shear;   ///< 4m
  Eigen::VectorXd held_force;      ///< 2h, x and y on each held node by what holds it [N]
  std::vector<double> group_force; ///< on the sheet along each group's direction [N]
  double largest_turn = 0.0;       ///< largest change of a shear angle in the last increment [rad]

  // Since the start [J]
  double shear_work = 0.0, shear_dissipated = 0.0, external_work = 0.0;
};

StaticsState start(const StaticsModel& model);

struct NewtonControls {
  int max_iterations = 25;
  double residual = 1e-8;   ///< largest free force over the largest force of any element on a node
  double correction = 1e-8; ///< largest correction over the extent of the sheet
};

/// How an increment went.
struct NewtonReport {
  bool converged = false;
  int iterations = 0;
  std::vector<double> residuals; ///< relative, before each iteration and after the last
  double residual_force = 0.0;   ///< largest free force [N]
  int worst_node = -1;           ///< where it is
  int negative_pivots = 0;       ///< of the last tangent: more than none, and the equilibrium is not stable
};

/// The equilibrium `dt` later by Newton's method with line search: one direct solution of the exact tangent
/// an iteration. The state moves only if it converges; histories are updated from t_n once more in every
/// iteration, so that nothing depends on the path of the iterations.
NewtonReport advance(const StaticsModel& model, StaticsState& s, double dt,
                     const NewtonControls& controls = {});

} // namespace towform
