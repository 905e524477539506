#include "mesh/blank_lattice.hpp"
#include "mesh/delaunay.hpp"
#include <algorithm>
#include <cmath>

namespace towform {
namespace {

// Found by trial: with these the smallest angle stays above 25 degrees, and edges point everywhere.
constexpr double side_clearance = 0.65; // in edges
constexpr double jitter = 0.35;         // either way along x and y, in edges
constexpr int rounds = 6;               // of smoothing and new triangulation
constexpr int sweeps = 2;               // of smoothing in a round

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

/// Moves every point to the area-weighted mean of the circumcentres of its triangles, which evens out angles
/// and areas together (optimal Delaunay triangulation: Chen and Xu, J. Comput. Math. 22, 2004). The first
/// `sides` points stay, the others stay inside.
void smooth(std::vector<Vec2>& points, int sides, const Rectangle& inside,
            const std::vector<Triangle>& triangles)
{
  std::vector<Vec2> moment(points.size());
  std::vector<double> area(points.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec2 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    const double twice = bx * cy - by * cx; // the circumcentre times this needs no division
    const Vec2 m{twice * a.x + 0.5 * (cy * b2 - by * c2), twice * a.y + 0.5 * (bx * c2 - cx * b2)};
    for (const int p : t) {
      moment[p].x += m.x;
      moment[p].y += m.y;
      area[p] += twice;
    }
  }
  for (std::size_t p = sides; p < points.size(); ++p) {
    if (!(area[p] > 0.0)) continue; // cannot happen before a point has left its neighbours' ring
    points[p] = {std::clamp(moment[p].x / area[p], inside.low.x, inside.high.x),
                 std::clamp(moment[p].y / area[p], inside.low.y, inside.high.y)};
  }
}

} // namespace

SurfaceMesh unstructured_mesh(const Rectangle& rectangle, double edge)
{
  std::vector<Vec2> points = divided_sides(rectangle, {edge});
  const int sides = static_cast<int>(points.size());
  const Lattice lattice = lattice_of(edge);
  const Rectangle inside = shrunk(rectangle, side_clearance * edge);
  const Rectangle limits = shrunk(rectangle, 0.4 * edge); // while smoothing
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
    for (int sweep = 0; sweep < sweeps; ++sweep) smooth(points, sides, limits, triangles);
    triangles = delaunay(points).triangles;
  }
  return flat_mesh(points, std::move(triangles));
}

std::int64_t count_unstructured_mesh(const Rectangle& rectangle, double edge)
{
  return count_triangles(lattice_of(edge), rectangle, {edge, side_clearance * edge});
}

} // namespace towform
