#include "mesh/element_shapes.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace towform {

std::vector<int> element_shapes(const SurfaceMesh& mesh)
{
  constexpr int many = 64;
  constexpr double rounding = 1e-9; // of the longest side along x or y
  const std::vector<Vec3>& p = mesh.points;
  double longest = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const Vec3& d : {p[b] - p[a], p[c] - p[a]}) longest = std::max({longest, std::abs(d.x), std::abs(d.y)});
  using Edges = std::array<std::int64_t, 4>; // from corner 0
  std::vector<std::pair<Edges, int>> sorted(mesh.triangles.size());
  parallel_ranges(static_cast<std::ptrdiff_t>(sorted.size()), [&](auto begin, auto end) {
    for (auto e = begin; e < end; ++e) {
      const auto& [a, b, c] = mesh.triangles[e];
      const Vec3 d1 = p[b] - p[a], d2 = p[c] - p[a];
      const auto whole = [&](double d) { return static_cast<std::int64_t>(std::llround(d / (rounding * longest))); };
      sorted[e] = {{whole(d1.x), whole(d1.y), whole(d2.x), whole(d2.y)}, static_cast<int>(e)};
    }
  });
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> shape(sorted.size(), -1);
  int number = 0;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto end = std::find_if(first, sorted.end(), [&](const auto& other) { return other.first != first->first; });
    if (end - first > many) {
      for (auto i = first; i != end; ++i) shape[i->second] = number;
      ++number;
    }
    first = end;
  }
  return shape;
}

} // namespace towform
