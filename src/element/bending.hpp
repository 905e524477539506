#pragma once
#include "element/curvature.hpp"
#include "element/moment_law.hpp"
#include "towform/state.hpp"
#include <vector>

namespace towform {

/// Bending of the sheet along its yarns, apart from the membrane (physics: elements), without rotations as
/// unknowns. The energy is
///   W = sum_n A_n (w1(kappa_1) + w2(kappa_2)),     dw/dkappa = M(kappa)
/// of the yarns' curvatures at the nodes, and the forces are its exact derivative. Free edges carry no
/// moment. Twist costs nothing: of all flat-lying shapes only w = (x . f1)(x . f2) is without energy.
struct Bending {
  CurvatureOperator curvature;
  std::vector<double> area; ///< of the node at each place of `curvature`; 0 where there is none [m^2]
  MomentLaw warp, weft;
  double damping_time = 0.0; ///< M += M'(0..) damping_time dkappa/dt, with the largest slope [s]
  int interval = 1;          ///< steps for which forces are held before they are computed again

  /// `node_area` of each node [m^2]; `clamped` edges meet their grips without a slope. Throws
  /// std::invalid_argument when the blank has too few nodes to tell its curvature.
  Bending(const Blank& blank, std::span<const SymmetryLine> clamped, std::span<const double> node_area,
          MomentLaw of_warp, MomentLaw of_weft);

  /// A bound of omega^2 at each node such that the largest bounds that of the sheet [1/s^2]: row sums of the
  /// linear operator over the nodes' masses [kg] (Gershgorin), with the largest slopes of the laws. Sharp
  /// for the zigzag of a regular mesh.
  [[nodiscard]] std::vector<double> frequency_bound(std::span<const double> mass) const;
};

/// What changes of it.
struct BendingState {
  std::vector<YarnPair> curvature; ///< at each place, when the forces were last computed [1/m]
  std::vector<Vec3> held;          ///< n, forces of several steps [N]; empty where they are computed at each
  std::vector<double> damping;     ///< per block, lost in bending since the start [J]
  std::vector<Vec3> image;         ///< of the mirror images [m]
};

/// Sizes a state for a sheet at `position`.
void start(const Bending& bending, std::span<const Vec3> position, BendingState& b);

/// Adds the bending forces to s.force: those at x_n or, between the steps at which they are computed, those that are held.
/// What will be held belongs to the middle of its time: to curvatures that have gone on as they did since the time before.
void bending_forces(const Bending& bending, BendingState& b, State& s, double dt);

/// Adds the forces -K u of small motions u [m] about a shape to `force`, K being that of the laws' largest slopes times
/// `factor` at the shape's normals; moments that turn with the normals are left out. `block_force` is room to work in.
void linear_bending_forces(const Bending& bending, double factor, std::span<const Vec3> position,
                           std::span<const Vec3> motion, std::vector<Vec3>& block_force, std::span<Vec3> force);

/// Elastic energy of bending at the state's curvatures [J].
double bending_energy(const Bending& bending, const BendingState& b);

} // namespace towform
