#pragma once
#include "towform/blank.hpp"

namespace towform {

/// Renumbers a flat mesh in place for locality: points by tiles; each triangle belongs to the tile of its lowest corner, keeps its
/// orientation and begins with the corner that others of its shape begin with. Within a tile triangles of one shape
/// (element_shapes) come together, and those that follow each other share no corner, mostly, so that a sum there need not wait
/// for the one before. Same mesh in, same bits out.
MeshTiles renumber(SurfaceMesh& mesh);

} // namespace towform
