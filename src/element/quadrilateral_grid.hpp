#pragma once
#include "towform/blank.hpp"
#include <array>
#include <vector>

namespace towform {

using Quadrilateral = std::array<int, 4>; ///< node numbers, counter-clockwise seen from +z

/// A flat rectangle of equal quadrilaterals, centred on the origin in the plane z = 0. Node i + (nx + 1) j
/// is the i-th along x and the j-th along y.
struct QuadrilateralGrid {
  std::vector<Vec3> points; ///< (nx + 1)(ny + 1)
  std::vector<Quadrilateral> elements;
  Vec3 warp, weft;        ///< unit reference yarn directions f01, f02
  double thickness = 0.0; ///< [m]
  int nx = 0, ny = 0;     ///< elements along x and y

  [[nodiscard]] int node(int i, int j) const { return i + (nx + 1) * j; }
  /// Each element as two triangles, 2e and 2e + 1: for files that know triangles only.
  [[nodiscard]] SurfaceMesh triangles() const;
};

/// The nearest grid to the wanted elements or edge. Throws std::invalid_argument with a message for the user:
/// lines that are not along the sides, symmetry, no size, more than a million elements.
QuadrilateralGrid make_quadrilateral_grid(const BlankParameters& parameters);

} // namespace towform
