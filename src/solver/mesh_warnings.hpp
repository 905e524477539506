#pragma once
#include "solver/model.hpp"
#include "towform/case.hpp"
#include <string>

namespace towform {

/// What the blank's mesh may do to the answer, in lines for the user; empty when there is nothing to say.
std::string mesh_warnings(const Case& c, const Model& model);

} // namespace towform
