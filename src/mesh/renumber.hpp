#pragma once
#include "towform/surface_mesh.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// Numbers of the points along a Hilbert curve through their bounding box in the plane z = 0: neighbours on
/// the curve are neighbours in the plane. Points in the same cell of the curve's 2^26 by 2^26 stay in order.
std::vector<int> hilbert_order(std::span<const Vec2> points);

/// Renumbers a flat mesh in place for locality: points along a Hilbert curve, each triangle begins with its
/// lowest corner (orientation kept), triangles sorted by their corners. Same mesh in, same bits out.
void renumber(SurfaceMesh& mesh);

} // namespace towform
