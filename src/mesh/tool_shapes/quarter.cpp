#include "mesh/tool_shapes/quarter.hpp"
#include <algorithm>
#include <cassert>
#include <cmath>

namespace towform::shapes {

namespace {

double length(const Curve& curve, double from, double to)
{
  constexpr int samples = 64;
  double sum = 0.0;
  Vec3 last = curve(from);
  for (int i = 1; i <= samples; ++i) {
    const Vec3 next = curve(from + (to - from) * i / samples);
    sum += norm(next - last);
    last = next;
  }
  return sum;
}

} // namespace

Along<int> intervals(const Curve& curve, Along<double> spacing)
{
  // Two triangles at least in the quarter round a pole: fewer make the pole's facets needlessly blunt.
  Along<int> n{0, std::max(2, static_cast<int>(std::ceil(length(curve, 1.0, 2.0) / spacing.dome)))};
  if (spacing.middle > 0.0)
    n.middle = std::max(1, static_cast<int>(std::ceil(length(curve, 0.0, 1.0) / spacing.middle)));
  return n;
}

Ring Quarter::ring(const Curve& curve, Along<int> n)
{
  std::vector<Vec3> points;
  points.reserve(n.middle + n.dome + 1);
  for (int i = 0; i < n.middle; ++i) points.push_back(curve(static_cast<double>(i) / n.middle));
  for (int i = 0; i <= n.dome; ++i) points.push_back(curve(1.0 + static_cast<double>(i) / n.dome));
  return ring(std::move(points), n.middle);
}

Ring Quarter::ring(std::vector<Vec3> points, std::size_t join, std::size_t corner)
{
  // Rounding must not open a slit along a plane of symmetry.
  assert(std::abs(points.front().x) < 1e-12 && std::abs(points.back().y) < 1e-12);
  points.front().x = 0.0;
  points.back().y = 0.0;
  Ring ring;
  ring.join = join;
  ring.corner = corner;
  for (const Vec3& point : points) {
    ring.nodes.push_back(static_cast<int>(mesh_.points.size()));
    mesh_.points.push_back(point);
  }
  return ring;
}

void Quarter::loft(const std::vector<Ring>& rings)
{
  for (std::size_t i = 1; i < rings.size(); ++i) loft(rings[i - 1], rings[i]);
}

void Quarter::loft(const Ring& first, const Ring& second)
{
  const std::span<const int> a(first.nodes), b(second.nodes);
  zip(a.first(first.join + 1), b.first(second.join + 1));
  std::size_t i = first.join, j = second.join;
  if (first.corner > 0 && second.corner > 0) { // corner to corner, or facets there would fold over
    zip(a.subspan(i, first.corner + 1 - i), b.subspan(j, second.corner + 1 - j));
    i = first.corner;
    j = second.corner;
  }
  zip(a.subspan(i), b.subspan(j));
}

void Quarter::zip(std::span<const int> a, std::span<const int> b)
{
  const auto distance = [this](int i, int j) { return norm_squared(mesh_.points[i] - mesh_.points[j]); };
  // Of two equal diagonals rounding must not choose, or the mesh would depend on the compiler.
  constexpr double tie = 1.0 + 1e-9;
  std::size_t i = 0, j = 0;
  while (i + 1 < a.size() || j + 1 < b.size()) {
    const bool a_left = i + 1 < a.size(), b_left = j + 1 < b.size();
    if (a_left && (!b_left || distance(a[i + 1], b[j]) <= tie * distance(a[i], b[j + 1]))) {
      mesh_.triangles.push_back({a[i], a[i + 1], b[j]});
      ++i;
    } else {
      mesh_.triangles.push_back({a[i], b[j + 1], b[j]});
      ++j;
    }
  }
}

SurfaceMesh Quarter::mirrored() const
{
  SurfaceMesh whole;
  std::vector<std::array<int, 4>> copies; // node of each quarter
  copies.reserve(mesh_.points.size());
  for (const Vec3& p : mesh_.points) {
    std::array<int, 4> copy{};
    for (int quarter = 0; quarter < 4; ++quarter) {
      const bool flip_x = (quarter & 1) != 0, flip_y = (quarter & 2) != 0;
      if (flip_x && p.x == 0.0) {
        copy[quarter] = copy[quarter & 2];
      } else if (flip_y && p.y == 0.0) {
        copy[quarter] = copy[quarter & 1];
      } else {
        copy[quarter] = static_cast<int>(whole.points.size());
        whole.points.push_back({flip_x ? -p.x : p.x, flip_y ? -p.y : p.y, p.z});
      }
    }
    copies.push_back(copy);
  }
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const auto& [i, j, k] : mesh_.triangles) {
      const Triangle t{copies[i][quarter], copies[j][quarter], copies[k][quarter]};
      const bool reflected = quarter == 1 || quarter == 2;
      whole.triangles.push_back(reflected ? Triangle{t[0], t[2], t[1]} : t);
    }
  return whole;
}

} // namespace towform::shapes
