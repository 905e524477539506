#pragma once
#include "towform/blank.hpp"
#include "towform/case.hpp"
#include "towform/state.hpp"
#include <span>
#include <string>
#include <vector>

namespace towform {

/// Nodes of the blank's edges whose path is given: a grip's move along `direction`, a picture frame's with
/// the hinged arms that they lie on (BoundaryParameters). Without a motion they stand.
struct Boundary {
  std::string name;
  std::vector<int> nodes;
  std::vector<Vec3> start; ///< of each node: a grip's place on the flat blank [m]; in a picture frame the
                           ///< fractions of the way along the two arms, x and y [-]
  std::optional<Motion> motion; ///< d(t), displacement along the direction or of the frame's corner [m]
  Vec3 direction;               ///< of a grip, unit
  double arm = 0.0;             ///< L of a picture frame [m]; 0 for a grip
  double whole_edge = 1.0;      ///< edge over the part of it that is modelled

  /// A node's place once the motion has made `displacement`, and how that changes with it.
  struct Place {
    Vec3 position, slope; ///< x(d) [m], dx/dd [-]
  };
  [[nodiscard]] Place place(std::size_t i, double displacement) const;
};

/// What changes of a boundary. Displacement and force at t_n; force and work of the modelled part.
struct BoundaryState {
  double displacement = 0.0; ///< d [m]
  double moved = 0.0;        ///< d_n - d_(n-1) [m]
  double force = 0.0;        ///< conjugate to d, -sum f_i . dx_i/dd with f_i of the sheet: positive when the
                             ///< boundary is driven against the sheet's resistance [N]
  double work = 0.0;         ///< done on the sheet up to t_n, by the trapezoid rule [J]
};

/// The nodes that a boundary of the case holds: those on a side of the flat blank's bounding box. Throws
/// std::invalid_argument when that is a single node of an imported blank, and when a picture frame is asked
/// to shear beyond the angles of the shear-force surface before `end` [s].
Boundary make_boundary(const BoundaryParameters& parameters, const BlankParameters& size, const Blank& blank,
                       double end);

/// Moves the held nodes from t to t + dt in place of the integration: x_(n+1) on their path, v_(n+1/2) the
/// mean velocity of the step. Returns the largest speed.
double advance(const Boundary& boundary, BoundaryState& b, State& s, double time, double dt);

/// Takes the sheet's forces off the held nodes, completing force and work of the step that led here. Their
/// inertia is left out: their masses move with the grip as part of it.
void take_reaction(const Boundary& boundary, BoundaryState& b, State& s);

/// Of the held nodes [J].
double kinetic_energy(const Boundary& boundary, const State& s, std::span<const double> mass);

} // namespace towform
