#include "mesh/blank_lattice.hpp"
#include "mesh/delaunay.hpp"
#include <cmath>

namespace towform {
namespace {

// Found by trial: with these the smallest angle stays above 25 degrees, and edges point everywhere.
constexpr double clearance = 0.55; // from the sides, in edges
constexpr double jitter = 0.25;    // either way along x and y, in edges
constexpr int rounds = 4;          // of smoothing and new triangulation
constexpr int sweeps = 3;          // of smoothing in a round

constexpr double odd_angle = 0.35; // rad; any that keeps rows of points off the yarns' usual directions

Lattice lattice_of(double edge) { return {odd_angle, 0.5 * edge, std::sqrt(0.75) * edge, true}; }

/// The splitmix64 generator: the same numbers from every compiler, unlike <random>'s distributions.
class Random {
public:
  /// In [-1, 1).
  double next()
  {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return std::ldexp(static_cast<double>(z >> 11), -52) - 1.0;
  }

private:
  std::uint64_t state_ = 1;
};

/// Moves every point inside to the mean of its neighbours; the first `sides` points stay.
void smooth(std::vector<Vec2>& points, int sides, const std::vector<Triangle>& triangles)
{
  std::vector<Vec2> sum(points.size());
  std::vector<int> weight(points.size(), 0);
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) { // every neighbour is met twice, from both triangles of its edge
      Vec2& s = sum[t[k]];
      for (const int other : {t[(k + 1) % 3], t[(k + 2) % 3]}) {
        s.x += points[other].x;
        s.y += points[other].y;
      }
      weight[t[k]] += 2;
    }
  }
  for (std::size_t p = sides; p < points.size(); ++p)
    points[p] = {sum[p].x / weight[p], sum[p].y / weight[p]};
}

} // namespace

SurfaceMesh unstructured_mesh(const Rectangle& rectangle, double edge)
{
  std::vector<Vec2> points = divided_sides(rectangle, edge);
  const int sides = static_cast<int>(points.size());
  const Lattice lattice = lattice_of(edge);
  const Rectangle inside = shrunk(rectangle, clearance * edge);
  Random random;
  for (const LatticeRow& row : lattice_rows(lattice, inside)) {
    for (int k = 0; k < row.count; ++k) {
      const Vec2 p = lattice_point(lattice, row.first + k * row.step, row.row);
      const double dx = random.next(), dy = random.next();
      points.push_back({std::clamp(p.x + jitter * edge * dx, inside.low.x, inside.high.x),
                        std::clamp(p.y + jitter * edge * dy, inside.low.y, inside.high.y)});
    }
  }
  std::vector<Triangle> triangles = delaunay(points).triangles;
  for (int round = 0; round < rounds; ++round) {
    for (int sweep = 0; sweep < sweeps; ++sweep) smooth(points, sides, triangles);
    triangles = delaunay(points).triangles;
  }
  SurfaceMesh mesh;
  mesh.points.reserve(points.size());
  for (const Vec2& p : points) mesh.points.push_back({p.x, p.y, 0.0});
  mesh.triangles = std::move(triangles);
  return mesh;
}

std::int64_t count_unstructured_mesh(const Rectangle& rectangle, double edge)
{
  return count_triangles(lattice_of(edge), rectangle, edge, clearance * edge);
}

} // namespace towform
