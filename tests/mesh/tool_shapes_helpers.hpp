#pragma once
#include "towform/tool_shapes.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace towform::tool_tests {

constexpr double mm = 1e-3, degree = std::numbers::pi / 180.0;

inline const ToolShape& shape(const std::string& name)
{
  for (const ToolShape& s : tool_shapes())
    if (s.name == name) return s;
  throw std::out_of_range(name);
}

using Changes = std::map<std::string, double>;

inline std::vector<double> values_with(const ToolShape& s, const Changes& changes)
{
  std::vector<double> values = s.defaults();
  for (const auto& [name, value] : changes) {
    const auto p = std::find_if(s.parameters.begin(), s.parameters.end(),
                                [&n = name](const ShapeParameter& q) { return q.name == n; });
    if (p == s.parameters.end()) throw std::out_of_range(name);
    values[p - s.parameters.begin()] = value;
  }
  return values;
}

inline SurfaceMesh build(const std::string& name, const std::string& part, const Changes& changes = {})
{
  return shape(name).build(part, values_with(shape(name), changes));
}

inline Vec3 area_vector(const SurfaceMesh& m, const Triangle& t)
{
  return 0.5 * cross(m.points[t[1]] - m.points[t[0]], m.points[t[2]] - m.points[t[0]]);
}

inline double volume(const SurfaceMesh& m)
{
  double six = 0.0;
  for (const Triangle& t : m.triangles) six += dot(m.points[t[0]], cross(m.points[t[1]], m.points[t[2]]));
  return six / 6.0;
}

/// Angles between the normals of neighbouring facets, rad; throws unless every edge has one facet each way.
inline std::vector<double> dihedral_angles(const SurfaceMesh& m)
{
  std::map<std::pair<int, int>, int> facet; // of each directed edge
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!facet.emplace(std::pair(m.triangles[t][k], m.triangles[t][(k + 1) % 3]), static_cast<int>(t))
               .second)
        throw std::runtime_error("two facets run the same way along an edge");
  std::vector<double> angles;
  for (const auto& [edge, t] : facet) {
    const auto other = facet.find({edge.second, edge.first});
    if (other == facet.end()) throw std::runtime_error("an edge has only one facet");
    if (edge.first > edge.second) continue;
    const Vec3 a = area_vector(m, m.triangles[t]), b = area_vector(m, m.triangles[other->second]);
    angles.push_back(std::atan2(norm(cross(a, b)), dot(a, b)));
  }
  return angles;
}

/// Points of a facet: corners' mean, the edges' middles, three between.
inline std::vector<Vec3> samples(const SurfaceMesh& m, const Triangle& t)
{
  const Vec3 a = m.points[t[0]], b = m.points[t[1]], c = m.points[t[2]];
  const Vec3 mean = (1.0 / 3.0) * (a + b + c);
  return {mean,
          0.5 * (a + b),
          0.5 * (b + c),
          0.5 * (c + a),
          0.5 * (mean + a),
          0.5 * (mean + b),
          0.5 * (mean + c)};
}

} // namespace towform::tool_tests
