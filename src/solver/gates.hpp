#pragma once
#include "solver/energy.hpp"
#include "solver/measure.hpp"
#include "solver/model.hpp"
#include "towform/case.hpp"

namespace towform {

/// Every step: stops (RunStopped) when the speed of a node or tool is not finite or passes the yarns' wave
/// speed.
void check_motion(const Model& model, const System& s);

/// Every output interval: stops when a limit of the case is passed, naming what and where.
/// `fraction` of the run's time done, `kinetic_ratio` kinetic over internal energy, `penetration` deepest so
/// far [m].
void check_gates(const GateParameters& gates, const Model& model, const System& s, const Energies& energies,
                 const FieldExtremes& extremes, double fraction, double kinetic_ratio);

} // namespace towform
