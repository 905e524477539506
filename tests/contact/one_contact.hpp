#pragma once
#include "contact/contact.hpp"
#include <cmath>

namespace towform::test {

/// Forces of one tool on a sheet of nodes of `mass` [kg] that may have moved anywhere, or by `moved` at most [m].
inline void contact_forces(const Contact& contact, const Tool& tool, ToolState& tool_state, ContactState& state,
                           double mass, State& s, double dt, double moved = HUGE_VAL)
{
  const std::vector<double> masses(s.position.size(), mass);
  towform::contact_forces({&contact, 1}, {&tool, 1}, {&tool_state, 1}, {&state, 1}, masses, s, dt, moved);
}

} // namespace towform::test
