#pragma once
#include "towform/case.hpp"

namespace towform {

/// Adds what no single key can tell: contradictions between keys and missing alternatives. `c.locations`
/// says what the case gives.
void check_case(const Case& c, std::vector<InputIssue>& issues);

} // namespace towform
