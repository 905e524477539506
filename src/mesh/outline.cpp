#include "mesh/outline.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace towform {

std::vector<std::array<int, 2>> outline_edges(std::span<const Triangle> triangles)
{
  // By their lower node, which little memory is needed for: twice the higher one, and one more where the triangle rises to it.
  int nodes = 0;
  for (const Triangle& t : triangles) nodes = std::max({nodes, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<int> first(static_cast<std::size_t>(nodes) + 1, 0), edge(3 * triangles.size());
  const auto each_edge = [&](const auto& work) {
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) work(t[k], t[(k + 1) % 3]);
  };
  each_edge([&](int a, int b) { ++first[std::min(a, b) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> next(first.begin(), first.end() - 1);
  each_edge([&](int a, int b) { edge[next[std::min(a, b)]++] = 2 * std::max(a, b) + (a < b ? 1 : 0); });
  std::vector<std::array<int, 2>> outline;
  for (int low = 0; low < nodes; ++low) {
    const auto end = edge.begin() + first[low + 1];
    std::sort(edge.begin() + first[low], end);
    for (auto e = edge.begin() + first[low]; e != end;) {
      const auto after = std::find_if(e, end, [&](int other) { return other / 2 != *e / 2; });
      if (after - e == 1) outline.push_back(*e % 2 != 0 ? std::array{low, *e / 2} : std::array{*e / 2, low});
      e = after;
    }
  }
  return outline;
}

OutlinePoint last_crossing(std::span<const std::array<int, 2>> edges, std::span<const Vec3> position,
                           Vec2 from, Vec2 to)
{
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const Vec2 ray{(to.x - from.x) / length, (to.y - from.y) / length};
  const double on_ray = 1e-9 * length; // a node this near is on it
  const auto beside = [&](int n) {
    const double d = ray.x * (position[n].y - from.y) - ray.y * (position[n].x - from.x);
    return std::abs(d) <= on_ray ? 0.0 : d;
  };
  const auto along = [&](int n) {
    return ray.x * (position[n].x - from.x) + ray.y * (position[n].y - from.y);
  };

  OutlinePoint best;
  double farthest = 0.0, nearest = -1.0;
  const auto take = [&](const std::array<int, 2>& edge, double share) {
    const double distance = (1.0 - share) * along(edge[0]) + share * along(edge[1]);
    if (distance <= farthest) return;
    farthest = distance;
    best = {edge, share};
  };
  for (const auto& edge : edges) {
    const double a = beside(edge[0]), b = beside(edge[1]);
    if (a == 0.0) take(edge, 0.0);
    if (b == 0.0) take(edge, 1.0);
    if (a * b < 0.0) take(edge, a / (a - b));
  }
  if (farthest > 0.0) return best;
  for (const auto& edge : edges)
    for (const int end : {0, 1}) {
      const Vec3& p = position[edge[end]];
      const double distance = std::hypot(p.x - to.x, p.y - to.y);
      if (nearest >= 0.0 && distance >= nearest) continue;
      nearest = distance;
      best = {edge, static_cast<double>(end)};
    }
  return best;
}

} // namespace towform
