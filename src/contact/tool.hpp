#pragma once
#include "contact/tool_surface.hpp"
#include "towform/motion.hpp"
#include <optional>
#include <string>

namespace towform {

/// A rigid tool of the model: what never changes. It moves in translation only: along its motion's axis, or,
/// when pushed by a force, along that axis as a rigid body of `mass`; without either it stands.
struct Tool {
  std::string name;
  ToolSurface surface; ///< at the start
  double friction = 0.0;
  std::optional<Motion> motion;
  std::optional<double> force; ///< [N]
  Vec3 direction;              ///< of the motion or force, unit
  double mass = 0.0;           ///< of a force-driven tool [kg]
  double damping = 0.0; ///< of its motion on the springs of contact, fraction of critical: its guide's, against the ground
};

/// What changes of a tool. Displacement at t_n, velocity at t_(n-1/2), reaction at t_n.
struct ToolState {
  double displacement = 0.0; ///< along the tool's direction [m]
  double velocity = 0.0;     ///< [m/s]
  Vec3 reaction;             ///< force of the sheet on the tool [N]
  double stiffness = 0.0;    ///< of all that touches it, along its direction, at t_n [N/m]
  double work = 0.0;         ///< done on sheet and tool by what drives it, up to t_n [J]
  double damped = 0.0;       ///< lost in its own damping, up to t_n [J]
};

/// Velocity of a force-driven tool half a step later: kicked over `kick` [s] by its force, reaction and damping.
double next_velocity(const Tool& tool, const ToolState& s, double kick);

/// Moves a tool from t to t + dt, with the reaction at t; a force-driven one is kicked over `kick`, the time
/// between the two half steps.
void advance(const Tool& tool, ToolState& s, double time, double dt, double kick);

/// Completes the driver's work over the last step once the reaction at its end is known; `before` is the
/// reaction and `moved` the displacement of that step.
void account_work(const Tool& tool, ToolState& s, const Vec3& before, double moved);

} // namespace towform
