#include "mesh/outline.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

std::vector<std::array<int, 2>> outline_edges(std::span<const Triangle> triangles)
{
  struct Edge {
    int low, high;
    bool rising; // the triangle runs from low to high
    bool operator<(const Edge& b) const { return low < b.low || (low == b.low && high < b.high); }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<int, 2>> outline;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && !(edges[first] < edges[last])) ++last;
    const Edge& e = edges[first];
    if (last - first == 1)
      outline.push_back(e.rising ? std::array<int, 2>{e.low, e.high} : std::array<int, 2>{e.high, e.low});
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
