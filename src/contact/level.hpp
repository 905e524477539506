#pragma once
#include "contact/tool_surface.hpp"

namespace towform {

/// How far the plane of a facet goes on round it at least, over facets that lie in it to the last bit [m]: the distance of the
/// facet from the nearest edge beyond which that is no longer so, `most` where that is farther.
[[nodiscard]] double level_room(const ToolSurface& surface, int facet, double most);

} // namespace towform
