#include "mesh/blank_grid.hpp"
#include "mesh/blank_lattice.hpp"
#include "mesh/delaunay.hpp"
#include <algorithm>
#include <cstdlib>

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

/// Four lattice points of a cell lie on a circle, and rounding alone has chosen the diagonal between them:
/// puts the pattern's in its place. A triangle has one such side at most, so no flip hinders another.
/// Points before `sides` are not of the lattice.
void restore_pattern(Triangulation& mesh, const std::vector<Key>& keys, int sides, Pattern pattern)
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
      if (std::min({p, q, a, b}) < sides) continue;
      const Key &kp = keys[p - sides], &kq = keys[q - sides], &ka = keys[a - sides], &kb = keys[b - sides];
      if (kp + kq == ka + kb && !is_pattern_edge(ka, kb, pattern) && is_pattern_edge(kp, kq, pattern)) {
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
  std::vector<Vec2> points = divided_sides(rectangle, edge);
  const int sides = static_cast<int>(points.size());
  const Lattice lattice = lattice_of(edge, angle, pattern);
  std::vector<Key> keys;
  for (const LatticeRow& row : lattice_rows(lattice, shrunk(rectangle, clearance * edge))) {
    for (int k = 0; k < row.count; ++k) {
      keys.push_back({row.first + k * row.step, row.row});
      points.push_back(lattice_point(lattice, keys.back().column, keys.back().row));
    }
  }
  Triangulation triangulation = delaunay(points);
  restore_pattern(triangulation, keys, sides, pattern);

  SurfaceMesh mesh;
  mesh.points.reserve(points.size());
  for (const Vec2& p : points) mesh.points.push_back({p.x, p.y, 0.0});
  mesh.triangles = std::move(triangulation.triangles);
  return mesh;
}

std::int64_t count_turned_grid(const Rectangle& rectangle, double edge, double angle, Pattern pattern)
{
  return count_triangles(lattice_of(edge, angle, pattern), rectangle, edge, clearance * edge);
}

} // namespace towform
