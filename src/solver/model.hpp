#pragma once
#include "contact/contact.hpp"
#include "element/bending.hpp"
#include "element/membrane.hpp"
#include "element/stable_step.hpp"
#include "element/step_limit.hpp"
#include "solver/boundary.hpp"
#include "solver/gravity.hpp"
#include "solver/pressure.hpp"
#include "towform/blank.hpp"
#include "towform/case.hpp"
#include <vector>

namespace towform {

/// The stable step at some time, as measured with contact (StepLimit), beside the guaranteed one of the sheet alone (StepBound)
/// [s].
struct StepLook {
  double step = 0.0, bound = 0.0;
  [[nodiscard]] double over_bound() const { return step / bound; }
};

/// What a case becomes: everything that does not change while it runs.
struct Model {
  Blank blank;
  FabricMaterial material;
  Membrane membrane;
  std::vector<Bending> bending;     ///< one, or none for a sheet that does not resist bending
  std::vector<Gravity> gravity;     ///< one or none
  std::vector<Pressure> pressure;   ///< one or none
  std::vector<double> element_mass; ///< m, with mass scaling [kg]
  std::vector<double> mass;         ///< n, lumped [kg]
  bool lumped = false;              ///< not in thirds of triangles on their corners (Case: time.lumping)
  double added_mass_fraction = 0.0; ///< by mass scaling, over the sheet's own
  double wave_speed = 0.0;          ///< fastest of the yarns' waves [m/s]
  double mass_damping = 0.0;        ///< [1/s]
  double shear_modulus = 0.0;       ///< bound of dN/dtheta, for the stable step [N/m]
  double safety = 1.0;              ///< step over the stable step
  ToolSprings tool_springs;         ///< of each tool that touches a node
  StepLook first_look;              ///< of the flat sheet
  double first_step = 0.0;          ///< [s]; later steps are never longer
  double temperature = 0.0;         ///< of the sheet [K]
  double mirror_factor = 1.0;       ///< whole sheet over the modelled part
  std::vector<Tool> tools;
  std::vector<Contact> contacts; ///< one a tool
  std::vector<Boundary> boundaries;
  std::vector<SymmetryLine> clamped; ///< edges in grips

  Model(Blank b, FabricMaterial m, Membrane sheet)
      : blank(std::move(b)), material(std::move(m)), membrane(std::move(sheet))
  {
  }
};

/// How many tools each node is taken to touch in the stable step.
struct TouchedTools {
  std::vector<double> counted; ///< n
  int rings = 0;               ///< of nodes that are counted with those that touch two tools or more
  bool more = false;           ///< one touches more than are counted of it: the step is to be looked at
};

/// All that changes while it runs.
struct System {
  State sheet;
  std::vector<BendingState> bending;
  std::vector<PressureState> pressure;
  std::vector<ToolState> tools;
  std::vector<ContactState> contacts;
  std::vector<BoundaryState> boundaries;
  TouchedTools touched;
  double fastest = 0.0; ///< bound of the nodes' speeds over the last step [m/s]
};

/// Meshes the blank, reads the tools, tabulates the material. Throws InputError with every issue found:
/// unreadable meshes, constituents out of range, a blank that starts inside a tool or that no tool can meet,
/// a picture frame opened too far.
Model build_model(const Case& c);

/// The system at rest at time 0, its forces not yet known.
System at_rest(const Model& model);

/// The same with its first forces.
System start(const Model& model);

} // namespace towform
