#pragma once
#include "towform/vec3.hpp"
#include <cstdint>

namespace towform {

/// A block of nodes side by side, so that one instruction serves several. What is seldom needed is looked at for a group of
/// eight together. Arrays are longer than they need be: a power of two apart, loads would wait for stores.
struct NodeLanes {
  static constexpr int size = 128;
  static constexpr int group = 8;
  using Lanes = double[size + 8]; // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise

  alignas(64) Lanes x, y, z;    ///< [m]
  // Where a tool touches the block:
  alignas(64) Lanes vx, vy, vz; ///< [m/s]
  alignas(64) Lanes area;       ///< of the sheet [m^2]
  alignas(64) Lanes fx, fy, fz; ///< sum of the tools' forces [N]
};

/// Components of `count` vectors side by side, and the sum back into vectors.
void split(const Vec3* from, int count, double* x, double* y, double* z);
void add(const double* x, const double* y, const double* z, int count, Vec3* to);

/// The part of a contact's state that belongs to a block (contact/contact.hpp).
struct ContactLanes {
  double *normal_x, *normal_y, *normal_z, *offset;
  const float *anchor_x, *anchor_y, *anchor_z, *reach_squared;
  double *stick_x, *stick_y, *stick_z, *normal_force;
  std::uint8_t *near, *touching; ///< of each group
};

/// What a tool does to all nodes of a block alike.
struct ContactLaw {
  Vec3 shift, velocity, direction; ///< of the tool
  double half_thickness, stiffness_per_area, soft, soft_depth, damping_per_area, stick_ratio, friction, dt;
};

/// Sums over a block: the force on the sheet, energies of the step.
struct ContactSums {
  Vec3 force;
  double elastic = 0.0, damped = 0.0, rubbed = 0.0;
  double stiffness = 0.0;   ///< of the nodes that touch, along the tool's direction [N/m]
  double penetration = 0.0; ///< deepest [m]
};

/// Offset of a plane that nobody touches.
constexpr double no_plane = -1e9; // [m]

/// Marks the nodes of a block that are out of their plane's reach, to be searched for; returns how many. Single precision
/// will do: reaches are told shorter by as much.
int look(const NodeLanes& nodes, const ContactLanes& c, const Vec3& shift, int count, std::int32_t* marks);

/// How far each of a block's nodes may move at least before one is out of its plane's reach, or ball's [m].
double least_room(const NodeLanes& nodes, const ContactLanes& c, const Vec3& shift, int count);

/// Gaps of a block's nodes, where a group of them was measured.
struct GapLanes {
  alignas(64) NodeLanes::Lanes gap; ///< [m]
  double least[NodeLanes::size / NodeLanes::group]; ///< of each group [m] // NOLINT(modernize-avoid-c-arrays)
};
/// Measures the gaps of `groups`, `count` of them; returns whether nodes are so deep that they may be behind their plane.
bool measure(const NodeLanes& nodes, const ContactLanes& c, const ContactLaw& law, const std::uint8_t* groups, int count, GapLanes& gaps);

/// Sums over a block of what it is pressed by, side by side for each place in a group.
struct PressLanes {
  using Lanes = double[NodeLanes::group]; // NOLINT(modernize-avoid-c-arrays)
  alignas(64) Lanes fx{}, fy{}, fz{}, elastic{}, damped{}, rubbed{}, stiffness{}, depth{};
};
ContactSums total(const PressLanes& sums);

/// Measures likewise, and presses: the normal force of a spring, softer at first touch (Contact), and damping, never pulling;
/// Coulomb friction by stick-slip return mapping: a step's tangential movement stretches the spring k_t = `stick_ratio` k and lets
/// it slip back to the cone of `friction`; the dashpot beside it acts while the node sticks. Nodes off the tool are without force.
/// Of `groups` those from number `from` on, as far as it returns: a group with nodes that are so deep that they may be behind
/// their plane waits until they have been `searched` for, when it is the first.
int press(NodeLanes& nodes, const ContactLanes& c, const ContactLaw& law, const std::uint8_t* groups, int from, int count,
          bool searched, GapLanes& gaps, PressLanes& sums);

} // namespace towform
