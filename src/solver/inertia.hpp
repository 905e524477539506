#pragma once
#include "solver/model.hpp"

namespace towform {

/// Masses, damping, steps and contact of a model whose sheet, laws, loads and tools are there: what depends on one another.
void set_inertia(const Case& c, Model& model);

} // namespace towform
