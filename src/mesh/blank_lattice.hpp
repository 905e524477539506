#pragma once
#include "towform/blank.hpp"
#include <cstdint>
#include <functional>
#include <vector>

namespace towform {

/// The part of the plane that is meshed.
struct Rectangle {
  Vec2 low, high;
};

/// A plane lattice through `origin`: row `row` lies `row * row_gap` to the left of the line at `angle`, its
/// points are `column * column_gap` along it, column and row both even or both odd when `staggered`.
struct Lattice {
  double angle = 0.0;                     ///< of the rows against x [rad]
  double column_gap = 1.0, row_gap = 1.0; ///< [m]
  bool staggered = false;
  Vec2 origin{};
};

/// Points of one row of a lattice within a rectangle: columns first, first + step, …, count of them.
struct LatticeRow {
  int row = 0, first = 0, step = 1, count = 0;
};

std::vector<LatticeRow> lattice_rows(const Lattice& lattice, const Rectangle& inside);
Vec2 lattice_point(const Lattice& lattice, int column, int row);

/// How the points of a lattice and those of the sides share the rectangle.
struct Division {
  double edge = 1.0;       ///< wanted between points of a side [m]
  double clearance = 0.0;  ///< least distance of a lattice point from the sides [m]
  double mirror_gap = 0.0; ///< if not 0, sides through the origin have points at its multiples instead [m]
};

/// Points on the sides, counter-clockwise from the lower left corner, each side evenly divided.
std::vector<Vec2> divided_sides(const Rectangle& rectangle, const Division& division);

/// Triangles of any triangulation of the divided sides and the lattice points inside them.
std::int64_t count_triangles(const Lattice& lattice, const Rectangle& rectangle, const Division& division);

/// A mesh in the plane z = 0.
SurfaceMesh flat_mesh(const std::vector<Vec2>& points, std::vector<Triangle> triangles);

/// The rectangle made smaller by `clearance` on every side; may be empty (low above high).
Rectangle shrunk(const Rectangle& rectangle, double clearance);

/// The edge near `estimate` whose count of triangles comes closest to the wanted one.
double edge_for_count(double wanted, double estimate, const std::function<std::int64_t(double)>& count);

/// A square grid turned by any angle, in the inside of a rectangle, joined to the evenly divided sides.
struct TurnedGrid {
  double edge = 1.0;  ///< of a cell [m]
  double angle = 0.0; ///< of its lines against x [rad]
  Pattern pattern = Pattern::diagonal;
  double side = 1.0; ///< distance of the points on the sides over the cell's edge
  Vec2 shift{};      ///< of the grid's origin from that of the blank, in edges along x and y
};

SurfaceMesh turned_grid(const Rectangle& rectangle, const TurnedGrid& grid);
std::int64_t count_turned_grid(const Rectangle& rectangle, const TurnedGrid& grid);

/// The grid whose triangles in the rectangle come closest to the wanted number; `estimate` of the edge [m].
TurnedGrid turned_grid_for_elements(const Rectangle& rectangle, double wanted, double estimate, double angle,
                                    Pattern pattern);

/// Near-equilateral triangles of about this edge [m] in no particular direction.
SurfaceMesh unstructured_mesh(const Rectangle& rectangle, double edge);
std::int64_t count_unstructured_mesh(const Rectangle& rectangle, double edge);

} // namespace towform
