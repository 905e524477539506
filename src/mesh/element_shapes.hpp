#pragma once
#include "towform/surface_mesh.hpp"
#include <vector>

namespace towform {

/// Which elements of a flat mesh are the same but for where they lie, corner by corner: the number of the shape that an element
/// shares with many others, or -1. Rounding aside; numbers do not depend on the order of the elements.
std::vector<int> element_shapes(const SurfaceMesh& mesh);

} // namespace towform
