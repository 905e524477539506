#include "mesh/blank_grid.hpp"
#include "mesh/blank_lattice.hpp"
#include "mesh/delaunay.hpp"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

namespace towform {
namespace {

// Grid points nearer to a side than this, in cell edges, make way for those on the side.
constexpr double clearance = 0.65;

/// Corners of the cells; with `cross` their centres too, on a staggered lattice of half the gap, where rows
/// of corners are even and rows of centres odd.
Lattice lattice_of(double edge, double angle, Pattern pattern)
{
  if (pattern == Pattern::cross) return {angle, 0.5 * edge, 0.5 * edge, true};
  return {angle, edge, edge, false};
}

/// At 45 degrees the grid is its own mirror image: the modelled part then has the grid's points on its mirror
/// planes, where the diagonals of cells lie.
Division division_of(double edge, double angle, Pattern pattern)
{
  const double right_angle = 0.5 * std::numbers::pi;
  const bool diagonal = std::abs(std::remainder(angle - 0.5 * right_angle, right_angle)) < 1e-9;
  const double gap = (pattern == Pattern::cross ? std::numbers::sqrt2 / 2 : std::numbers::sqrt2) * edge;
  return {edge, clearance * edge, diagonal ? gap : 0.0};
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
  const Key key{static_cast<int>(std::lround((p.x * c + p.y * s) / lattice.column_gap)),
                static_cast<int>(std::lround((p.y * c - p.x * s) / lattice.row_gap))};
  const Vec2 q = lattice_point(lattice, key.column, key.row);
  const bool exists = !lattice.staggered || (key.column - key.row) % 2 == 0;
  if (!exists || std::hypot(p.x - q.x, p.y - q.y) > 1e-6 * lattice.row_gap) return {};
  return key;
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

SurfaceMesh turned_grid(const Rectangle& rectangle, double edge, double angle, Pattern pattern)
{
  const Lattice lattice = lattice_of(edge, angle, pattern);
  std::vector<Vec2> points = divided_sides(rectangle, division_of(edge, angle, pattern));
  std::vector<std::optional<Key>> keys;
  for (const Vec2& p : points) keys.push_back(key_at(p, lattice));
  for (const LatticeRow& row : lattice_rows(lattice, shrunk(rectangle, clearance * edge))) {
    for (int k = 0; k < row.count; ++k) {
      const int column = row.first + k * row.step;
      keys.push_back(Key{column, row.row});
      points.push_back(lattice_point(lattice, column, row.row));
    }
  }
  Triangulation triangulation = delaunay(points);
  restore_pattern(triangulation, keys, pattern);
  return flat_mesh(points, std::move(triangulation.triangles));
}

std::int64_t count_turned_grid(const Rectangle& rectangle, double edge, double angle, Pattern pattern)
{
  return count_triangles(lattice_of(edge, angle, pattern), rectangle, division_of(edge, angle, pattern));
}

} // namespace towform
