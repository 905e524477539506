#pragma once
#include "towform/surface_mesh.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// Numbers of the points along a Hilbert curve through their bounding box in the plane z = 0: neighbours on
/// the curve are neighbours in the plane. Points in the same cell of the curve's 2^26 by 2^26 stay in order.
std::vector<int> hilbert_order(std::span<const Vec2> points);

/// Points of the plane in tiles of nearly equal numbers of points, as square as can be: tile after tile, and row after row in each.
struct Tiles {
  std::vector<int> order; ///< points
  std::vector<int> first; ///< where each tile begins in `order`
};
/// `most` points in a tile, roughly. Where points stand in rows and columns, tiles have straight sides.
Tiles tiles_of(std::span<const Vec2> points, int most);

/// Renumbers a flat mesh in place for locality: points by tiles, each triangle begins with its lowest corner (orientation
/// kept) and belongs to its tile; triangles that follow each other share no corner, mostly, so that a sum there need not wait for
/// the one before. Same mesh in, same bits out. Returns the first triangle of every tile.
std::vector<int> renumber(SurfaceMesh& mesh);

} // namespace towform
