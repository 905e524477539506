#include "mesh/surface_check.hpp"
#include "mesh/bucket_sort.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <tuple>

namespace towform {
namespace {

// Below this ratio of height to longest edge, single-precision corners leave the normal undefined.
constexpr double flat = 1e-6;

bool is_degenerate(const SurfaceMesh& mesh, const Triangle& t)
{
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  const double longest = std::max({norm_squared(b - a), norm_squared(c - b), norm_squared(a - c)});
  return norm(cross(b - a, c - a)) <= flat * longest;
}

/// Keeps the lowest facet and counts.
void add(std::optional<SurfaceFault>& fault, SurfaceDefect defect, int facet, int other)
{
  if (!fault) fault = SurfaceFault{defect, facet, other, 0};
  if (std::tie(facet, other) < std::tie(fault->facet, fault->other)) {
    fault->facet = facet;
    fault->other = other;
  }
  ++fault->count;
}

std::optional<SurfaceFault> find_degenerate(const SurfaceMesh& mesh)
{
  std::optional<SurfaceFault> fault;
  const int facets = static_cast<int>(mesh.triangles.size());
  for (int f = 0; f < facets; ++f) {
    if (is_degenerate(mesh, mesh.triangles[f])) add(fault, SurfaceDefect::degenerate, f, f);
  }
  return fault;
}

std::optional<SurfaceFault> find_duplicates(const SurfaceMesh& mesh)
{
  std::vector<std::pair<Triangle, int>> keys;
  keys.reserve(mesh.triangles.size());
  for (Triangle t : mesh.triangles) {
    std::sort(t.begin(), t.end());
    keys.emplace_back(t, static_cast<int>(keys.size()));
  }
  bucket_sort(keys, mesh.points.size(), [](const auto& k) { return k.first[0]; }, std::less{});
  std::optional<SurfaceFault> fault;
  for (std::size_t first = 0, k = 1; k < keys.size(); ++k) {
    if (keys[k].first != keys[first].first) {
      first = k;
    } else {
      add(fault, SurfaceDefect::duplicate, keys[k].second, keys[first].second);
    }
  }
  return fault;
}

struct HalfEdge {
  int low = 0, high = 0; // points
  int facet = 0;
  bool rising = false; // the facet runs from low to high
};

std::vector<HalfEdge> sorted_edges(const SurfaceMesh& mesh)
{
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  const int facets = static_cast<int>(mesh.triangles.size());
  for (int f = 0; f < facets; ++f) {
    const Triangle& t = mesh.triangles[f];
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), f, a < b});
    }
  }
  bucket_sort(
      edges, mesh.points.size(), [](const HalfEdge& e) { return e.low; },
      [](const HalfEdge& a, const HalfEdge& b) { return std::tie(a.high, a.facet) < std::tie(b.high, b.facet); });
  return edges;
}

std::optional<SurfaceFault> find_bad_edges(const SurfaceMesh& mesh)
{
  const std::vector<HalfEdge> edges = sorted_edges(mesh);
  std::optional<SurfaceFault> crowded, orientation;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].low == edges[first].low &&
           edges[last].high == edges[first].high)
      ++last;
    if (last - first > 2) {
      add(crowded, SurfaceDefect::crowded, edges[first].facet, edges[first].facet);
    } else if (last - first == 2 && edges[first].rising == edges[first + 1].rising) {
      add(orientation, SurfaceDefect::orientation, edges[first].facet, edges[first + 1].facet);
    }
  }
  return crowded ? crowded : orientation;
}

} // namespace

std::optional<SurfaceFault> check_surface(const SurfaceMesh& mesh)
{
  if (auto fault = find_degenerate(mesh)) return fault;
  if (auto fault = find_duplicates(mesh)) return fault;
  return find_bad_edges(mesh);
}

std::string describe(const SurfaceFault& fault)
{
  const int facet = fault.facet + 1, other = fault.other + 1, count = fault.count;
  switch (fault.defect) {
  case SurfaceDefect::degenerate:
    return fmt::format("facet {} has no area or repeats a corner ({} such facet{} in all); remove degenerate "
                       "facets in the program that made the mesh",
                       facet, count, count == 1 ? "" : "s");
  case SurfaceDefect::duplicate:
    return fmt::format("facet {} has the same corners as facet {} ({} such facet{} in all); remove duplicate "
                       "facets in the program that made the mesh",
                       facet, other, count, count == 1 ? "" : "s");
  case SurfaceDefect::crowded:
    return fmt::format("facet {} shares an edge with more than one other facet ({} such edge{} in all); "
                       "keep only the surface that touches the sheet",
                       facet, count, count == 1 ? "" : "s");
  case SurfaceDefect::orientation:
    break;
  }
  return fmt::format("facets {} and {} share an edge but face opposite sides ({} such edge{} in all); orient "
                     "all normals outwards in the program that made the mesh",
                     facet, other, count, count == 1 ? "" : "s");
}

} // namespace towform
