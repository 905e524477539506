#include "mesh/renumber.hpp"
#include <algorithm>
#include <utility>

namespace towform {
namespace {

constexpr int bits = 26;

/// Distance along the Hilbert curve of order `bits`, by the usual quadrant-by-quadrant descent.
std::uint64_t hilbert_distance(std::uint32_t x, std::uint32_t y)
{
  constexpr std::uint32_t last = (1u << bits) - 1;
  std::uint64_t distance = 0;
  for (std::uint32_t side = 1u << (bits - 1); side > 0; side /= 2) {
    const bool right = (x & side) != 0, upper = (y & side) != 0;
    distance = 4 * distance + (right ? (upper ? 2u : 3u) : (upper ? 1u : 0u));
    if (!upper) { // the lower quadrants hold the curve turned
      if (right) {
        x = last - x;
        y = last - y;
      }
      std::swap(x, y);
    }
  }
  return distance;
}

} // namespace

std::vector<int> hilbert_order(std::span<const Vec2> points)
{
  if (points.empty()) return {};
  Vec2 low = points.front(), high = low;
  for (const Vec2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, 1e-300});
  const double scale = ((1u << bits) - 1) / extent;
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(points.size());
  for (const Vec2& p : points) {
    const auto x = static_cast<std::uint32_t>((p.x - low.x) * scale);
    const auto y = static_cast<std::uint32_t>((p.y - low.y) * scale);
    keys.emplace_back(hilbert_distance(x, y), static_cast<int>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(keys.size());
  for (const auto& [distance, point] : keys) order.push_back(point);
  return order;
}

void renumber(SurfaceMesh& mesh)
{
  std::vector<Vec2> flat;
  flat.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) flat.push_back({p.x, p.y});
  const std::vector<int> order = hilbert_order(flat);

  std::vector<int> number(order.size());
  std::vector<Vec3> points(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    number[order[k]] = static_cast<int>(k);
    points[k] = mesh.points[order[k]];
  }
  mesh.points = std::move(points);
  for (Triangle& t : mesh.triangles) {
    t = {number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  mesh.triangles.shrink_to_fit();
}

} // namespace towform
