#pragma once
#include "towform/surface_mesh.hpp"
#include <span>
#include <vector>

namespace towform {

/// Triangles of a set of points in the plane, counter-clockwise, covering its convex hull.
struct Triangulation {
  std::vector<Triangle> triangles;
  std::vector<Triangle> neighbours; ///< across the edge opposite each corner; -1 outside the hull
};

/// Delaunay triangulation by incremental insertion (Bowyer, Watson), n log n in time. Every point becomes a
/// corner, points on the hull's sides too. Decisions are exact for the points rounded to a lattice of 2^26
/// steps along the longer side of their bounding box, so points on a common line x = const or y = const
/// stay on it. Throws std::invalid_argument when two points round to the same place or all lie on a line.
Triangulation delaunay(std::span<const Vec2> points);

} // namespace towform
