#pragma once
#include "solver/model.hpp"
#include <vector>

namespace towform {

/// How far each node's surface is from the nearest tool's: the node's signed distance from it less half the
/// thickness [m]; negative inside the tool. Behind the rim of an open tool there is none, and the distance
/// counts as positive. Empty without tools. A search over all facets: for output, not for steps.
std::vector<double> clearances(const Model& model, const System& s);

} // namespace towform
