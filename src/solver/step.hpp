#pragma once
#include "solver/model.hpp"
#include "solver/phases.hpp"

namespace towform {

/// One step of central differences: velocities to n + 1/2, positions to n + 1, forces at n + 1.
void step(const Model& model, System& s, double dt, Phases& phases);

/// Forces of everything at the present positions; dt is the step that led to them.
void evaluate_forces(const Model& model, System& s, double dt, Phases& phases);

} // namespace towform
