#include "mesh/blank_grid.hpp"
#include "mesh/blank_lattice.hpp"
#include "mesh/delaunay.hpp"
#include "mesh/yarn_directions.hpp"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>

namespace towform {
namespace {

// Grid points nearer to a side than this, in cell edges, make way for those on the side.
constexpr double clearance = 0.65;

/// Corners of the cells; with `cross` their centres too, on a staggered lattice of half the gap, where rows
/// of corners are even and rows of centres odd.
Lattice lattice_of(const TurnedGrid& g)
{
  const Vec2 origin{g.shift.x * g.edge, g.shift.y * g.edge};
  if (g.pattern == Pattern::cross) return {g.angle, 0.5 * g.edge, 0.5 * g.edge, true, origin};
  return {g.angle, g.edge, g.edge, false, origin};
}

bool is_diagonal(double angle)
{
  return std::abs(std::remainder(angle - 0.5 * right_angle, right_angle)) < 1e-9;
}

struct Key {
  int column, row;
  bool operator==(const Key&) const = default;
};
Key operator+(Key a, Key b) { return {a.column + b.column, a.row + b.row}; }

/// Is the line between two lattice points an edge of the pattern?
bool is_pattern_edge(Key a, Key b, Pattern pattern)
{
  const int dx = b.column - a.column, dy = b.row - a.row, adx = std::abs(dx), ady = std::abs(dy);
  if (pattern == Pattern::cross) {
    const bool corners = a.row % 2 == 0 && b.row % 2 == 0;
    return (adx == 1 && ady == 1) || (corners && adx + ady == 2 && adx * ady == 0);
  }
  if (adx + ady == 1) return true;
  const bool rising = dx * dy > 0;
  return adx == 1 && ady == 1 &&
         rising == rising_diagonal(std::min(a.column, b.column), std::min(a.row, b.row));
}

/// The lattice point that lies at p, if any does.
std::optional<Key> key_at(const Vec2& p, const Lattice& lattice)
{
  const double c = std::cos(lattice.angle), s = std::sin(lattice.angle);
  const double x = p.x - lattice.origin.x, y = p.y - lattice.origin.y;
  const Key key{static_cast<int>(std::lround((x * c + y * s) / lattice.column_gap)),
                static_cast<int>(std::lround((y * c - x * s) / lattice.row_gap))};
  const Vec2 q = lattice_point(lattice, key.column, key.row);
  const bool exists = !lattice.staggered || (key.column - key.row) % 2 == 0;
  if (!exists || std::hypot(p.x - q.x, p.y - q.y) > 1e-6 * lattice.row_gap) return {};
  return key;
}

/// At 45 degrees the diagonals of cells lie along the sides. The grid is then its own mirror image, and the
/// modelled part has the grid's points on its mirror planes; when all corners of the rectangle are points of
/// the grid, the other sides have them too and no cell is out of shape.
Division division_of(const Rectangle& r, const TurnedGrid& g)
{
  Division division{g.side * g.edge, clearance * g.edge, 0.0};
  if (!is_diagonal(g.angle)) return division;
  division.mirror_gap =
      (g.pattern == Pattern::cross ? std::numbers::sqrt2 / 2 : std::numbers::sqrt2) * g.edge;
  const Lattice lattice = lattice_of(g);
  const Vec2 corners[] = {r.low, {r.high.x, r.low.y}, r.high, {r.low.x, r.high.y}};
  if (std::all_of(std::begin(corners), std::end(corners), [&](const Vec2& p) { return key_at(p, lattice); }))
    division.edge = division.mirror_gap;
  return division;
}

/// Four lattice points of a cell lie on a circle, and rounding alone has chosen the diagonal between them:
/// puts the pattern's in its place. A triangle has one such side at most, so no flip hinders another.
void restore_pattern(Triangulation& mesh, const std::vector<std::optional<Key>>& keys, Pattern pattern)
{
  std::vector<bool> done(mesh.triangles.size());
  const int count = static_cast<int>(mesh.triangles.size());
  for (int t = 0; t < count; ++t) {
    for (int k = 0; k < 3 && !done[t]; ++k) {
      const int n = mesh.neighbours[t][k];
      if (n <= t || done[n]) continue;
      Triangle &here = mesh.triangles[t], &there = mesh.triangles[n];
      const Triangle& back = mesh.neighbours[n];
      const int p = here[k], a = here[(k + 1) % 3], b = here[(k + 2) % 3];
      const int q = there[std::find(back.begin(), back.end(), t) - back.begin()];
      if (!(keys[p] && keys[q] && keys[a] && keys[b])) continue;
      if (*keys[p] + *keys[q] == *keys[a] + *keys[b] && !is_pattern_edge(*keys[a], *keys[b], pattern) &&
          is_pattern_edge(*keys[p], *keys[q], pattern)) {
        here = {p, a, q};
        there = {p, q, b};
        done[t] = done[n] = true;
      }
    }
  }
}

} // namespace

SurfaceMesh turned_grid(const Rectangle& rectangle, const TurnedGrid& grid)
{
  const Lattice lattice = lattice_of(grid);
  const Division division = division_of(rectangle, grid);
  std::vector<Vec2> points = divided_sides(rectangle, division);
  std::vector<std::optional<Key>> keys;
  keys.reserve(points.size());
  for (const Vec2& p : points) keys.push_back(key_at(p, lattice));
  for (const LatticeRow& row : lattice_rows(lattice, shrunk(rectangle, division.clearance))) {
    for (int k = 0; k < row.count; ++k) {
      const int column = row.first + k * row.step;
      keys.push_back(Key{column, row.row});
      points.push_back(lattice_point(lattice, column, row.row));
    }
  }
  Triangulation triangulation = delaunay(points);
  restore_pattern(triangulation, keys, grid.pattern);
  return flat_mesh(points, std::move(triangulation.triangles));
}

std::int64_t count_turned_grid(const Rectangle& rectangle, const TurnedGrid& grid)
{
  return count_triangles(lattice_of(grid), rectangle, division_of(rectangle, grid));
}

TurnedGrid turned_grid_for_elements(const Rectangle& rectangle, double wanted, double estimate, double angle,
                                    Pattern pattern)
{
  // At 45 degrees whole rows of points enter at once on both sides. Where no mirror plane needs the grid's
  // lines, half a row's shift gives the counts between; finer or coarser sides do a little everywhere.
  std::vector<Vec2> shifts{{0.0, 0.0}};
  if (is_diagonal(angle) && rectangle.low.x < 0.0 && rectangle.low.y < 0.0) {
    const double half_row = 0.25 * std::numbers::sqrt2;
    shifts.insert(shifts.end(), {{half_row, 0.0}, {0.0, half_row}, {half_row, half_row}});
  }
  TurnedGrid best;
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {1.0, 0.9, 1.1, 0.8, 1.2}) {
    for (const Vec2& shift : shifts) {
      TurnedGrid g{estimate, angle, pattern, side, shift};
      const auto count = [&](double edge) {
        g.edge = edge;
        return count_turned_grid(rectangle, g);
      };
      g.edge = edge_for_count(wanted, estimate, count);
      const double error = std::abs(static_cast<double>(count_turned_grid(rectangle, g)) - wanted);
      if (error < least) {
        least = error;
        best = g;
      }
    }
    if (least <= 0.005 * wanted) break; // good enough to keep the better sides
  }
  return best;
}

} // namespace towform
