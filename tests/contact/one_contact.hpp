#pragma once
#include "contact/contact.hpp"

namespace towform::test {

/// Forces of one tool on a sheet of nodes of `mass` [kg].
inline void contact_forces(const Contact& contact, const Tool& tool, ToolState& tool_state, ContactState& state,
                           double mass, State& s, double dt)
{
  const std::vector<double> masses(s.position.size(), mass);
  towform::contact_forces({&contact, 1}, {&tool, 1}, {&tool_state, 1}, {&state, 1}, masses, s, dt);
}

} // namespace towform::test
