#pragma once
#include "solver/session.hpp"

namespace towform {

/// Runs a session, and describes a run, of a case with solver = "implicit".
RunOutcome run_statics(Session& session);
std::string describe_statics(const Case& c);

} // namespace towform
