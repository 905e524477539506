#include "mesh/point_order.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
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

namespace {

/// Cuts a set of points in two, and these, until they are tiles.
class Cutter {
public:
  Cutter(std::span<const Vec2> points, Tiles& tiles) : points_(points), tiles_(tiles) {}

  /// Cuts what stands from `begin` to `end` of the order into `count` tiles.
  void cut(std::ptrdiff_t begin, std::ptrdiff_t end, int count)
  {
    if (count <= 1) {
      tiles_.first.push_back(static_cast<int>(begin));
      sort(begin, end);
      return;
    }
    const int less = count / 2;
    const auto border = part(begin, begin + (end - begin) * less / count, end);
    cut(begin, border, less);
    cut(border, end, count - less);
  }

private:
  /// Width and height of the box that holds some of the order.
  [[nodiscard]] Vec2 size(std::ptrdiff_t begin, std::ptrdiff_t end) const
  {
    Vec2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    for (auto i = begin; i < end; ++i) {
      const Vec2& p = points_[tiles_.order[i]];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {high.x - low.x, high.y - low.y};
  }

  /// Brings those at one end of the box, along its longer side, to the front: as many as there are before `middle`, or about as
  /// many where they stand in rows, all of a row or none of it. Returns where the others begin.
  std::ptrdiff_t part(std::ptrdiff_t begin, std::ptrdiff_t middle, std::ptrdiff_t end)
  {
    constexpr double rounding = 1e-6; // of the side
    constexpr double most_off = 0.1;  // of those wanted
    const auto [width, height] = size(begin, end);
    const bool wide = width >= height;
    const double Vec2::*const along = wide ? &Vec2::x : &Vec2::y;
    const double Vec2::*const across = wide ? &Vec2::y : &Vec2::x;
    const double row = rounding * std::max(width, height);
    const auto at = [&](std::ptrdiff_t i) { return tiles_.order.begin() + i; };
    std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
      const Vec2 &p = points_[a], &q = points_[b];
      return std::tuple(p.*along, p.*across, a) < std::tuple(q.*along, q.*across, b);
    });
    const double border = points_[*at(middle)].*along;
    const auto below = [&](double limit) {
      return std::count_if(at(begin), at(end), [&](int p) { return points_[p].*along < limit; });
    };
    const auto wanted = middle - begin, without = below(border - row), with = below(border + row);
    const bool takes_row = with - wanted < wanted - without;
    const auto taken = takes_row ? with : without;
    if (static_cast<double>(std::abs(taken - wanted)) > most_off * static_cast<double>(wanted)) return middle;
    const double limit = takes_row ? border + row : border - row;
    std::partition(at(begin), at(end), [&](int p) { return points_[p].*along < limit; });
    return begin + taken;
  }

  /// Along a Hilbert curve, whatever the order was.
  void sort(std::ptrdiff_t begin, std::ptrdiff_t end)
  {
    std::vector<int> its(tiles_.order.begin() + begin, tiles_.order.begin() + end);
    std::sort(its.begin(), its.end(), [&](int a, int b) {
      const Vec2 &p = points_[a], &q = points_[b];
      return std::tuple(p.x, p.y, a) < std::tuple(q.x, q.y, b);
    });
    std::vector<Vec2> places;
    for (const int p : its) places.push_back(points_[p]);
    const std::vector<int> order = hilbert_order(places);
    std::transform(order.begin(), order.end(), tiles_.order.begin() + begin, [&](int i) { return its[i]; });
  }

  std::span<const Vec2> points_;
  Tiles& tiles_;
};

} // namespace

Tiles tiles_of(std::span<const Vec2> points, int most)
{
  Tiles tiles;
  tiles.order.resize(points.size());
  std::iota(tiles.order.begin(), tiles.order.end(), 0);
  const auto count = static_cast<int>(points.size());
  Cutter(points, tiles).cut(0, count, (count + most - 1) / most);
  return tiles;
}

} // namespace towform
