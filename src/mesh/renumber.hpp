#pragma once
#include "towform/surface_mesh.hpp"
#include <vector>

namespace towform {

/// Renumbers a flat mesh in place for locality: points by tiles, each triangle begins with its lowest corner (orientation
/// kept) and belongs to its tile; triangles that follow each other share no corner, mostly, so that a sum there need not wait for
/// the one before. Same mesh in, same bits out. Returns the first triangle of every tile.
std::vector<int> renumber(SurfaceMesh& mesh);

} // namespace towform
