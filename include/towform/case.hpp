#pragma once
#include "towform/blank.hpp"
#include "towform/error.hpp"
#include "towform/material.hpp"
#include "towform/motion.hpp"
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// A rigid tool: driven by a motion, pushed by a force, or fixed when it has neither.
struct ToolParameters {
  std::string name;
  std::filesystem::path mesh; ///< found file
  double mesh_unit = 1.0;     ///< length of the file's unit [m]
  Vec3 position;              ///< added to the mesh at the start [m]
  double friction = 0.0;      ///< Coulomb coefficient against the sheet
  std::optional<Motion> motion;
  std::optional<double> force; ///< along `axis` [N]; the tool then moves as a rigid body along it
  Axis axis = Axis::z;         ///< of the force
  double mass = 0.0;           ///< of a force-driven tool [kg]
  double damping = 0.0;        ///< of its motion on what it touches, fraction of critical
};

/// Edges of the blank that a specimen test holds and moves.
///
/// A grip holds every node of one edge: all three components fixed, or, with a motion, moved rigidly along
/// its axis and held across it. A picture frame holds all four edges of a square blank in rigid arms of its
/// side L, hinged at the corners: corner (-a/2, -b/2) is fixed and the opposite one moves by the motion's
/// displacement d along the diagonal (axis has no meaning; d > 0 opens the frame), which shears the sheet by
///   theta = pi/2 - 2 acos(1/sqrt 2 + d/(2L))                                                        (Eq. 13)
/// Nodes keep their fraction of the way along their arm.
struct BoundaryParameters {
  enum class Kind { grip, picture_frame };
  enum class Edge { left, right, bottom, top }; ///< x = -a/2, x = a/2, y = -b/2, y = b/2

  std::string name;
  Kind kind = Kind::grip;
  Edge edge = Edge::left; ///< of a grip
  std::optional<Motion> motion;
};

struct TimeParameters {
  double end = 0.0;           ///< [s]
  double safety = 0.85;       ///< step over the stable step
  double lumping = 0.0;       ///< share of the sheet's mass that is put where yarns hold nodes stiffly
  double mass_scaling = 1.0;  ///< uniform factor on the sheet's mass
  std::optional<double> step; ///< wanted step [s]: only elements that need it are made heavier
  double mass_damping = 0.0;  ///< force -a m v on every node [1/s]
  bool subcycling = true;     ///< bending every few steps where that is enough
};

/// A point of a pressure over time.
struct PressurePoint {
  double time = 0.0;     ///< [s]
  double pressure = 0.0; ///< [Pa]
};

struct LoadParameters {
  Vec3 gravity;                        ///< acceleration of every part of the sheet [m/s^2]
  std::vector<PressurePoint> pressure; ///< on the face that looks along +z at the start; empty without
};

struct ContactParameters {
  double penalty = 0.3;    ///< beta of the penalty stiffness beta m / dt^2, dt the step with masses in thirds
  double soft = 1.0;       ///< stiffness at first touch over that
  double soft_depth = 0.0; ///< how deep it is, over the sheet's thickness
  double damping = 0.0;    ///< fraction of critical, normal to the tool
  double stick = 1.0;      ///< stiffness and damping along a tool over those normal to it

  /// What the springs and dashpots of two tools, with velocities half a step old, add normal to them to a node's stiffness, over
  /// node mass / step^2.
  [[nodiscard]] double two_tools() const { return 2.0 * penalty + 8.0 * damping * std::sqrt(penalty); }
  /// The part of a step that the sheet may take beside that, squared: (omega dt)^2 + two_tools <= 4.
  [[nodiscard]] double room() const { return 1.0 - 0.25 * two_tools(); }
};

/// Limits that stop a run when passed.
struct GateParameters {
  double energy_error = 0.0;        ///< over external work [-]
  double kinetic_to_internal = 0.0; ///< over the second half of the run [-]
  double penetration = 0.0;         ///< of the sheet's surface into a tool [m]
  double yarn_strain = 0.0;         ///< 99th percentile of |strain| over the elements [-]
};

struct OutputParameters {
  int frames = 30;   ///< after the initial one
  int history = 200; ///< rows of history.csv after the initial one
  double checkpoint = 300.0; ///< wall time between checkpoints [s]; 0: only when the run is interrupted
  bool report = true;        ///< write report.html when the run ends
};

/// What a report judges and compares by; nothing of it acts on a run.
struct ReportParameters {
  double locking_angle = 0.0;         ///< shear above which the sheet is taken to wrinkle [rad]
  std::filesystem::path reference;    ///< found file of points to draw over the sheet's; empty without
  std::string where, columns;         ///< choices from it, as `towform compare` takes them, between commas
  std::vector<double> from, to;       ///< x, y of a section's ends, or empty [m]
  std::optional<Vec3> centre;         ///< of the sphere on which polar angles are counted [m]
  bool mirror = false, nodal = false; ///< as for `towform compare`
};

/// Explicit dynamics, or quasi-static equilibrium by Newton's method.
enum class SolverKind { explicit_dynamics, implicit };

/// A case as read: every value resolved, in SI units, within its range.
struct Case {
  std::string title;
  std::filesystem::path path; ///< the case file
  std::string text;           ///< its text, as read
  SolverKind solver = SolverKind::explicit_dynamics;
  BlankParameters blank;
  MaterialParameters material;
  std::vector<ToolParameters> tools;
  std::vector<BoundaryParameters> boundaries;
  LoadParameters load;
  TimeParameters time;
  ContactParameters contact;
  GateParameters gates;
  OutputParameters output;
  ReportParameters report;
  std::map<std::string, SourceLocation> locations; ///< of every key given, as "blank.size", "tool[0].mesh"

  /// Where a key was given; where its table or the file is when it was not.
  [[nodiscard]] SourceLocation where(const std::string& key) const;
};

/// Reads and validates a case file; `overrides` are `key.path=value` texts that replace or add keys
/// (a tool's or boundary's keys by its name, `tool.punch.friction=0.1`). Cards and meshes are looked for in
/// the case's folder, the current folder and towform's own data. Throws InputError with every issue found.
Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// Reads a case's [material] and its blank's thickness and nothing else: what a prediction of the sheet's
/// shear resistance needs. The rest of the case may be missing. Throws InputError with every issue found.
Case read_material(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The case with every value written out, defaults too, as a TOML text that reads back to the same case.
std::string resolved_case(const Case& c);

/// One line per key: name, unit, default, range, meaning (from the table that also reads the case).
std::string key_reference();

} // namespace towform
