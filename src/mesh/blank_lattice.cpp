#include "mesh/blank_lattice.hpp"
#include <algorithm>
#include <cmath>

namespace towform {
namespace {

struct Interval {
  double low, high;
};

/// Keeps the t for which low <= offset + slope t <= high.
Interval cut(Interval t, double offset, double slope, double low, double high)
{
  if (slope == 0.0) return offset < low || offset > high ? Interval{1.0, -1.0} : t;
  const double a = (low - offset) / slope, b = (high - offset) / slope;
  return {std::max(t.low, std::min(a, b)), std::min(t.high, std::max(a, b))};
}

int divisions(double length, double edge)
{
  return std::max(1, static_cast<int>(std::lround(length / edge)));
}

/// Points between a and b, on a line through the origin, at multiples of the gap from there.
void divide_mirror(std::vector<Vec2>& points, Vec2 a, Vec2 b, double gap)
{
  const bool along_x = a.y == b.y;
  const double from = along_x ? a.x : a.y, to = along_x ? b.x : b.y, sign = from < to ? 1.0 : -1.0;
  const double shortest = 0.65; // between the last of them and the end of the line, in gaps
  const int first = static_cast<int>(std::ceil(sign * from / gap + shortest));
  const int last = static_cast<int>(std::floor(sign * to / gap - shortest));
  for (int k = first; k <= last; ++k) {
    const double at = sign * k * gap + 0.0; // no negative zero
    points.push_back(along_x ? Vec2{at, a.y} : Vec2{a.x, at});
  }
}

} // namespace

Vec2 lattice_point(const Lattice& lattice, int column, int row)
{
  const double c = std::cos(lattice.angle), s = std::sin(lattice.angle);
  const double u = column * lattice.column_gap, v = row * lattice.row_gap;
  return {u * c - v * s + lattice.origin.x + 0.0,
          u * s + v * c + lattice.origin.y + 0.0}; // no negative zeros
}

std::vector<LatticeRow> lattice_rows(const Lattice& lattice, const Rectangle& inside)
{
  if (inside.low.x > inside.high.x || inside.low.y > inside.high.y) return {};
  const Vec2 low{inside.low.x - lattice.origin.x, inside.low.y - lattice.origin.y};
  const Vec2 high{inside.high.x - lattice.origin.x, inside.high.y - lattice.origin.y};
  const double c = std::cos(lattice.angle), s = std::sin(lattice.angle);
  const auto [v_low, v_high] = std::minmax(
      {low.y * c - low.x * s, low.y * c - high.x * s, high.y * c - low.x * s, high.y * c - high.x * s});
  const int first_row = static_cast<int>(std::ceil(v_low / lattice.row_gap));
  const int last_row = static_cast<int>(std::floor(v_high / lattice.row_gap));
  const double reach = std::abs(low.x) + std::abs(low.y) + std::abs(high.x) + std::abs(high.y);

  std::vector<LatticeRow> rows;
  for (int row = first_row; row <= last_row; ++row) {
    const double v = row * lattice.row_gap;
    Interval u{-reach, reach};
    u = cut(u, -v * s, c, low.x, high.x);
    u = cut(u, v * c, s, low.y, high.y);
    int first = static_cast<int>(std::ceil(u.low / lattice.column_gap));
    const int last = static_cast<int>(std::floor(u.high / lattice.column_gap));
    const int step = lattice.staggered ? 2 : 1;
    if (lattice.staggered && (first - row) % 2 != 0) ++first;
    if (first <= last) rows.push_back({row, first, step, (last - first) / step + 1});
  }
  return rows;
}

std::vector<Vec2> divided_sides(const Rectangle& rectangle, const Division& division)
{
  const auto& [low, high] = rectangle;
  const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  std::vector<Vec2> points;
  for (int side = 0; side < 4; ++side) {
    const Vec2 &a = corners[side], &b = corners[(side + 1) % 4];
    points.push_back(a);
    const bool mirror = (a.x == 0.0 && b.x == 0.0) || (a.y == 0.0 && b.y == 0.0);
    if (mirror && division.mirror_gap > 0.0) {
      divide_mirror(points, a, b, division.mirror_gap);
      continue;
    }
    const int n = divisions(std::abs(b.x - a.x) + std::abs(b.y - a.y), division.edge);
    for (int k = 1; k < n; ++k) {
      points.push_back({a.x + (b.x - a.x) * k / n, a.y + (b.y - a.y) * k / n}); // exact where a.x == b.x
    }
  }
  return points;
}

Rectangle shrunk(const Rectangle& rectangle, double clearance)
{
  const auto& [low, high] = rectangle;
  return {{low.x + clearance, low.y + clearance}, {high.x - clearance, high.y - clearance}};
}

std::int64_t count_triangles(const Lattice& lattice, const Rectangle& rectangle, const Division& division)
{
  std::int64_t inside = 0;
  for (const LatticeRow& row : lattice_rows(lattice, shrunk(rectangle, division.clearance)))
    inside += row.count;
  const auto sides = static_cast<std::int64_t>(divided_sides(rectangle, division).size());
  return 2 * inside + sides - 2; // Euler's formula
}

SurfaceMesh flat_mesh(const std::vector<Vec2>& points, std::vector<Triangle> triangles)
{
  SurfaceMesh mesh;
  mesh.points.reserve(points.size());
  for (const Vec2& p : points) mesh.points.push_back({p.x, p.y, 0.0});
  mesh.triangles = std::move(triangles);
  return mesh;
}

double edge_for_count(double wanted, double estimate, const std::function<std::int64_t(double)>& count)
{
  double edge = estimate;
  for (int k = 0; k < 20; ++k) edge *= std::sqrt(static_cast<double>(count(edge)) / wanted);
  // The count jumps where rows of points enter or leave: look round the fixed point too.
  double best = edge, least = std::abs(static_cast<double>(count(edge)) - wanted);
  for (int k = 1; k <= 200; ++k) {
    for (const double factor : {1.0 + 0.0005 * k, 1.0 / (1.0 + 0.0005 * k)}) {
      const double error = std::abs(static_cast<double>(count(edge * factor)) - wanted);
      if (error < least) {
        least = error;
        best = edge * factor;
      }
    }
    if (least <= 0.001 * wanted) break;
  }
  return best;
}

} // namespace towform
