#pragma once
#include "towform/vec3.hpp"

namespace towform {

/// A block of nodes side by side, so that one instruction serves several.
struct NodeLanes {
  static constexpr int size = 128;
  using Lanes = double[size]; // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise

  alignas(64) Lanes x, y, z;    ///< [m]
  alignas(64) Lanes vx, vy, vz; ///< [m/s]
  alignas(64) Lanes fx, fy, fz; ///< sum of the tools' forces [N]
};

/// The part of a contact's state that belongs to a block (contact/contact.hpp).
struct ContactLanes {
  double *normal_x, *normal_y, *normal_z, *offset;
  double *anchor_x, *anchor_y, *anchor_z, *reach_squared;
  double *stick_x, *stick_y, *stick_z, *normal_force;
};

/// What a tool does to all nodes of a block alike.
struct ContactLaw {
  Vec3 shift, velocity; ///< of the tool
  double half_thickness, stiffness_per_mass, damping_per_mass, stick_ratio, friction, dt;
};

/// Sums over a block: the force on the sheet, energies of the step.
struct ContactSums {
  Vec3 force;
  double elastic = 0.0, damped = 0.0, rubbed = 0.0;
  double penetration = 0.0; ///< deepest [m]
};

/// Offset of a plane that nobody touches.
constexpr double no_plane = -1e9; // [m]

/// How many nodes of a block are to be searched for, being out of their plane's reach, and are marked so; how many have
/// a plane that they may touch.
struct Awake {
  int marked, near;
};
Awake look(const NodeLanes& nodes, const ContactLanes& c, const ContactLaw& law, int count, long long* marks);

/// Normal force k g + damping, never pulling; Coulomb friction by stick-slip return mapping: a step's
/// tangential movement stretches the spring k_t = `stick_ratio` k and lets it slip back to the cone of
/// `friction`; the dashpot beside it acts while the node sticks. Nodes off the tool are without force.
ContactSums push(NodeLanes& nodes, const ContactLanes& c, const double* mass, const ContactLaw& law, int count);

} // namespace towform
