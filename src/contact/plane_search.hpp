#pragma once
#include "contact/contact.hpp"
#include "contact/tool.hpp"

namespace towform {

/// Finds the tool's point nearest to a node at p [tool's frame], and remembers the plane that tells its distance from now on, or
/// the ball in which nobody touches the tool.
void search_plane(const Contact& contact, const Tool& tool, ContactPlanes& planes, const Vec3& p, int node);

} // namespace towform
