#include "mesh/renumber.hpp"
#include "mesh/point_order.hpp"
#include <algorithm>
#include <cstddef>
#include <span>

namespace towform {

namespace {

/// Brings apart what follows each other: one after the other of several runs.
void deal_out(std::span<Triangle> triangles)
{
  constexpr std::size_t runs = 8;
  const std::vector<Triangle> sorted(triangles.begin(), triangles.end());
  const std::size_t length = (sorted.size() + runs - 1) / runs;
  auto to = triangles.begin();
  for (std::size_t i = 0; i < length; ++i)
    for (std::size_t place = i; place < sorted.size(); place += length) *to++ = sorted[place];
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
