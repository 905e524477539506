#pragma once
#include "contact/contact.hpp"
#include <cmath>

namespace towform::test {

/// Forces of one tool on a sheet whose nodes have `area` each [m^2], that may have moved anywhere, or by `moved` at most [m].
inline void contact_forces(const Contact& contact, const Tool& tool, ToolState& tool_state, ContactState& state,
                           double area, State& s, double dt, double moved = HUGE_VAL)
{
  const std::vector<double> areas(s.position.size(), area);
  towform::contact_forces({&contact, 1}, {&tool, 1}, {&tool_state, 1}, {&state, 1}, areas, {}, s, dt, moved);
}

} // namespace towform::test
