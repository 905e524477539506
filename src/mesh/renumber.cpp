#include "mesh/renumber.hpp"
#include "mesh/element_shapes.hpp"
#include "mesh/point_order.hpp"
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

namespace towform {

namespace {

/// Lets a triangle begin with the corner that lies farthest back along a direction that no side is likely to be square to:
/// triangles of one shape begin alike.
void turn(const std::vector<Vec3>& points, Triangle& t)
{
  constexpr Vec3 ahead{0.955, 0.296, 0.0};
  const auto back = [&](int n, int m) { return dot(points[n] - points[m], ahead) < 0.0; };
  std::rotate(t.begin(), std::min_element(t.begin(), t.end(), back), t.end());
}

/// Brings apart what follows each other: one after the other of several runs.
void deal_out(std::span<int> elements)
{
  constexpr std::size_t runs = 8;
  const std::vector<int> sorted(elements.begin(), elements.end());
  const std::size_t length = (sorted.size() + runs - 1) / runs;
  auto to = elements.begin();
  for (std::size_t i = 0; i < length; ++i)
    for (std::size_t place = i; place < sorted.size(); place += length) *to++ = sorted[place];
}

/// Puts a tile's elements into the order in which they are computed: shape after shape, as many of each as vectors share evenly,
/// then what is left over.
void put_in_order(std::span<const int> shape, std::span<int> elements)
{
  constexpr std::ptrdiff_t side_by_side = 8;
  std::vector<int> left_over;
  std::stable_sort(elements.begin(), elements.end(), [&](int e, int f) { return shape[e] < shape[f]; });
  auto to = elements.begin();
  for (auto first = elements.begin(); first != elements.end();) {
    const auto end = std::find_if(first, elements.end(), [&](int e) { return shape[e] != shape[*first]; });
    const std::ptrdiff_t even = shape[*first] < 0 ? 0 : (end - first) / side_by_side * side_by_side;
    left_over.insert(left_over.end(), first + even, end);
    std::copy(first, first + even, to);
    deal_out({to, to + even});
    to += even;
    first = end;
  }
  std::sort(left_over.begin(), left_over.end());
  std::copy(left_over.begin(), left_over.end(), to);
  deal_out({to, elements.end()});
}

} // namespace

MeshTiles renumber(SurfaceMesh& mesh)
{
  // A tile has twice as many triangles as points: of a small sheet few, so that there are enough tiles for several threads, and no more
  // than a cache holds of any other. The larger the tiles, the fewer strips of yarn cross their borders.
  constexpr int fewest_points = 420, most_points = 850, tiles_wanted = 16;
  const int tile_points = std::clamp(static_cast<int>(mesh.points.size()) / tiles_wanted, fewest_points, most_points);
  std::vector<Vec2> flat;
  flat.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) flat.push_back({p.x, p.y});
  Tiles tiles = tiles_of(flat, tile_points);

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

  std::vector<int> first_triangles;
  for (const int point : tiles.first) {
    const auto first = std::lower_bound(mesh.triangles.begin(), mesh.triangles.end(), Triangle{point, -1, -1});
    first_triangles.push_back(static_cast<int>(first - mesh.triangles.begin()));
  }
  for (Triangle& t : mesh.triangles) turn(mesh.points, t);
  const std::vector<int> shape = element_shapes(mesh);
  std::vector<int> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t t = 0; t < first_triangles.size(); ++t) {
    const auto end = t + 1 < first_triangles.size() ? static_cast<std::size_t>(first_triangles[t + 1]) : order.size();
    put_in_order(shape, std::span(order).first(end).subspan(static_cast<std::size_t>(first_triangles[t])));
  }
  std::vector<Triangle> ordered;
  ordered.reserve(order.size());
  for (const int e : order) ordered.push_back(mesh.triangles[e]);
  mesh.triangles = std::move(ordered);
  return {std::move(first_triangles), std::move(tiles.first)};
}

} // namespace towform
