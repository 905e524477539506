#pragma once
#include "solver/energy.hpp"
#include "solver/measure.hpp"
#include "solver/model.hpp"
#include "towform/case.hpp"

namespace towform {

/// The deepest contact of any step since the last output.
struct DeepestContact {
  double depth = 0.0; ///< [m]
  int contact = 0, node = 0;
  double moved = 0.0; ///< by the tool in that step [m]
  double time = 0.0;  ///< [s]
};

/// Every step: stops (RunStopped) when the speed of a node or tool is not finite or passes the yarns' wave
/// speed.
void check_motion(const Model& model, const System& s);

/// Every output interval: stops when a limit of the case is passed, naming what and where.
/// `fraction` of the run's time done, `kinetic_ratio` kinetic over internal energy.
void check_gates(const GateParameters& gates, const Model& model, const System& s, const Energies& energies,
                 const FieldExtremes& extremes, const DeepestContact& deepest, double fraction,
                 double kinetic_ratio);

} // namespace towform
