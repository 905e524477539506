#pragma once
#include "towform/vec3.hpp"
#include <span>
#include <vector>

namespace towform {

/// The points' numbers along a Hilbert curve through their bounding box in the plane z = 0: neighbours on
/// the curve are neighbours in the plane. Points in the same cell of the curve's 2^26 by 2^26 stay in order.
std::vector<int> hilbert_order(std::span<const Vec2> points);

/// Points of the plane in tiles of nearly equal numbers of points, as square as can be: tile after tile, along a Hilbert curve in each.
struct Tiles {
  std::vector<int> order; ///< points
  std::vector<int> first; ///< where each tile begins in `order`
};
/// `most` points in a tile, roughly. Where points stand in rows and columns, tiles have straight sides.
Tiles tiles_of(std::span<const Vec2> points, int most);

} // namespace towform
