#include "mesh/renumber.hpp"
#include <algorithm>
#include <array>
#include <cmath>
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
    const auto [low, high] = box(begin, end);
    const Vec2 size{high.x - low.x, high.y - low.y};
    const double rounding = 1e-6 * std::max(size.x, size.y);
    if (count <= 1) {
      tiles_.first.push_back(static_cast<int>(begin));
      sort_by_rows(begin, end, low, size, rounding);
      return;
    }
    const int less = count / 2;
    const auto middle = begin + (end - begin) * less / count;
    const auto along = size.x >= size.y ? &Vec2::x : &Vec2::y;
    const auto border = part(begin, middle, end, along, rounding);
    cut(begin, border, less);
    cut(border, end, count - less);
  }

private:
  [[nodiscard]] std::array<Vec2, 2> box(std::ptrdiff_t begin, std::ptrdiff_t end) const
  {
    std::array<Vec2, 2> box{Vec2{HUGE_VAL, HUGE_VAL}, Vec2{-HUGE_VAL, -HUGE_VAL}};
    for (auto i = begin; i < end; ++i) {
      const Vec2& p = points_[tiles_.order[i]];
      box[0] = {std::min(box[0].x, p.x), std::min(box[0].y, p.y)};
      box[1] = {std::max(box[1].x, p.x), std::max(box[1].y, p.y)};
    }
    return box;
  }

  /// Brings the lower ones to the front, about as many as there are before `middle`: all of a row or none of it, where there are
  /// rows. Returns where the others begin.
  std::ptrdiff_t part(std::ptrdiff_t begin, std::ptrdiff_t middle, std::ptrdiff_t end, double Vec2::*along, double rounding)
  {
    constexpr double most_off = 0.1; // of the lower ones
    const auto at = [&](std::ptrdiff_t i) { return tiles_.order.begin() + i; };
    const double Vec2::*const across = along == &Vec2::x ? &Vec2::y : &Vec2::x;
    std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
      const Vec2 &p = points_[a], &q = points_[b];
      return std::tuple(p.*along, p.*across, a) < std::tuple(q.*along, q.*across, b);
    });
    const double border = points_[*at(middle)].*along;
    const auto below = [&](double limit) {
      return std::count_if(at(begin), at(end), [&](int p) { return points_[p].*along < limit; });
    };
    double limit = border - rounding;
    auto lower = below(limit);
    const auto wanted = middle - begin;
    if (const auto with_row = below(border + rounding); with_row - wanted < wanted - lower) {
      limit = border + rounding;
      lower = with_row;
    }
    if (static_cast<double>(std::abs(lower - wanted)) > most_off * static_cast<double>(wanted)) return middle;
    std::partition(at(begin), at(end), [&](int p) { return points_[p].*along < limit; });
    return begin + lower;
  }

  /// Where points stand in no rows, bands as high as points are apart make them.
  void sort_by_rows(std::ptrdiff_t begin, std::ptrdiff_t end, const Vec2& low, const Vec2& size, double rounding)
  {
    const std::span<int> its(tiles_.order.begin() + begin, tiles_.order.begin() + end);
    const auto rows_of = [&](double height) {
      std::vector<std::tuple<double, double, int>> keys; // row, place in it, point
      for (const int p : its) keys.emplace_back(height > 0.0 ? std::floor((points_[p].y - low.y) / height + 0.5) : 0.0, points_[p].x, p);
      std::sort(keys.begin(), keys.end());
      return keys;
    };
    auto keys = rows_of(rounding);
    double rows = 1.0;
    for (std::size_t i = 1; i < keys.size(); ++i) rows += std::get<0>(keys[i]) != std::get<0>(keys[i - 1]) ? 1.0 : 0.0;
    const auto count = static_cast<double>(its.size());
    if (rows * rows > 4.0 * count) keys = rows_of(std::sqrt(size.x * size.y / count));
    std::transform(keys.begin(), keys.end(), its.begin(), [](const auto& key) { return std::get<2>(key); });
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

namespace {

/// Brings apart what follows each other in rows of two triangles a cell.
void deal_out(std::span<Triangle> triangles)
{
  constexpr std::size_t apart = 4;
  const std::vector<Triangle> sorted(triangles.begin(), triangles.end());
  auto to = triangles.begin();
  for (const std::size_t hand : {0, 2, 1, 3})
    for (std::size_t i = hand; i < sorted.size(); i += apart) *to++ = sorted[i];
}

} // namespace

std::vector<int> renumber(SurfaceMesh& mesh)
{
  constexpr int tile_points = 420; // and twice as many triangles
  std::vector<Vec2> flat;
  flat.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) flat.push_back({p.x, p.y});
  const Tiles tiles = tiles_of(flat, tile_points);

  std::vector<int> number(flat.size());
  std::vector<Vec3> points(flat.size());
  for (std::size_t k = 0; k < flat.size(); ++k) {
    number[tiles.order[k]] = static_cast<int>(k);
    points[k] = mesh.points[tiles.order[k]];
  }
  mesh.points = std::move(points);
  for (Triangle& t : mesh.triangles) {
    t = {number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  mesh.triangles.shrink_to_fit();

  std::vector<int> first_triangles;
  for (const int point : tiles.first) {
    const auto first = std::lower_bound(mesh.triangles.begin(), mesh.triangles.end(), Triangle{point, -1, -1});
    first_triangles.push_back(static_cast<int>(first - mesh.triangles.begin()));
  }
  for (std::size_t t = 0; t < first_triangles.size(); ++t) {
    const auto end = t + 1 < first_triangles.size() ? static_cast<std::size_t>(first_triangles[t + 1]) : mesh.triangles.size();
    deal_out(std::span(mesh.triangles).first(end).subspan(static_cast<std::size_t>(first_triangles[t])));
  }
  return first_triangles;
}

} // namespace towform
