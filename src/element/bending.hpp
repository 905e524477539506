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
  std::vector<double> area; ///< n, of each node [m^2]
  MomentLaw warp, weft;
  double damping_time = 0.0; ///< M += M'(0..) damping_time dkappa/dt, with the largest slope [s]

  /// `area` of each node [m^2]; `clamped` edges meet their grips without a slope. Throws
  /// std::invalid_argument when the blank has too few nodes to tell its curvature.
  Bending(const Blank& blank, std::span<const SymmetryLine> clamped, std::vector<double> node_area,
          MomentLaw of_warp, MomentLaw of_weft);

  /// A bound of omega^2 at each node such that the largest bounds that of the sheet [1/s^2]: row sums of the
  /// linear operator over the nodes' masses [kg] (Gershgorin), with the largest slopes of the laws. Sharp
  /// for the zigzag of a regular mesh.
  [[nodiscard]] std::vector<double> frequency_bound(std::span<const double> mass) const;

  /// Shares of each point in the nodes' forces, the transpose of the curvature's terms.
  struct Share {
    int node;
    double warp, weft;
  };
  std::vector<int> first_share, first_end; ///< of each point, images included
  std::vector<Share> shares;
  std::vector<unsigned> ends; ///< chord ends: 4 node + 0, 1, 2, 3 for a0, a1, b0, b1
};

/// What changes of it.
struct BendingState {
  /// A node's moments: the points round it are pushed by -(c_k^1 warp + c_k^2 weft) normal.
  struct Moments {
    Vec3 normal;
    double warp, weft; ///< A_n M_i [N m^2]
  };
  std::vector<YarnPair> curvature; ///< n, at x_n [1/m]
  std::vector<double> damping;     ///< n, lost in bending since the start [J]
  std::vector<Moments> moments;    ///< n
  std::vector<Vec3> turning;       ///< 2n, forces on the chords' ends a0 and b0, as they turn the normal [N]
  std::vector<Vec3> image, image_force;
};

/// Sizes a state for a sheet at `position`.
void start(const Bending& bending, std::span<const Vec3> position, BendingState& b);

/// Adds the bending forces at x_n to s.force.
void bending_forces(const Bending& bending, BendingState& b, State& s, double dt);

/// Elastic energy of bending at the state's curvatures [J].
double bending_energy(const Bending& bending, const BendingState& b);

} // namespace towform
