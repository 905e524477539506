#pragma once
#include "towform/run.hpp"

namespace towform {

/// `run` and `describe_run` of a case with solver = "implicit".
RunOutcome run_statics(const Case& c, const RunOptions& options);
std::string describe_statics(const Case& c);

} // namespace towform
