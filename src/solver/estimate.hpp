#pragma once
#include "solver/model.hpp"
#include <string>

namespace towform {

/// What a run is expected to cost. Both are estimates from runs of the double dome and say so: contact, the
/// machine and what else it does decide.
struct RunEstimate {
  double wall_time = 0.0; ///< [s]
  double memory = 0.0;    ///< [bytes]
};
RunEstimate estimate(const Case& c, const Model& model, int threads);

/// A line for a reader.
std::string estimate_text(const RunEstimate& estimate);

} // namespace towform
