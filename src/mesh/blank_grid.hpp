#pragma once
#include "towform/blank.hpp"

namespace towform {

/// Cells of a whole blank's grid along x and y; both even, so that grid lines are the centre lines.
struct GridCounts {
  int x = 2, y = 2;
};

/// Triangles that a cell is cut into: 4 for `cross`, else 2.
int triangles_per_cell(Pattern pattern);

/// Whether the cell whose lower left corner is grid point (i, j), counted from the centre of the blank, is
/// cut from lower left to upper right: where x y > 0, so that all diagonals run outwards and mirror each
/// other.
constexpr bool rising_diagonal(int i, int j) { return (i >= 0) == (j >= 0); }

/// The grid nearest to the wanted number of triangles: within 1 % and cells within 3 % of square if some
/// grid is both, else the best compromise.
GridCounts grid_for_elements(Vec2 size, int elements, Pattern pattern);

/// The grid nearest to the wanted edge of a cell [m].
GridCounts grid_for_edge(Vec2 size, double edge);

/// A grid along the sides of the rectangle, or its x >= 0 and y >= 0 parts. Coordinates do not depend on the
/// part, and those of mirrored nodes differ in sign only.
SurfaceMesh aligned_grid(Vec2 size, GridCounts counts, Pattern pattern, Symmetry symmetry);

} // namespace towform
