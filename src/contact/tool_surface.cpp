#include "contact/tool_surface.hpp"
#include "mesh/elements_of_node.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace towform {

namespace {

/// The facet that has an edge from one point to another, of several the last, or -1.
int facet_with_edge(std::span<const Triangle> triangles, const ElementsOfNode& facets, int from, int to)
{
  const std::span<const int> round = facets.of(static_cast<std::size_t>(from));
  for (auto facet = round.rbegin(); facet != round.rend(); ++facet)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles[*facet][k] == from && triangles[*facet][(k + 1) % 3] == to) return *facet;
  return -1;
}

} // namespace

ToolSurface::ToolSurface(SurfaceMesh mesh)
    : mesh_(std::move(mesh)), tree_(mesh_), edge_normal_(mesh_.triangles.size()),
      corner_normal_(mesh_.points.size()), border_corner_(mesh_.points.size(), 0), lowest_(mesh_.points.front()),
      highest_(mesh_.points.front())
{
  for (const Vec3& p : mesh_.points) {
    lowest_ = {std::min(lowest_.x, p.x), std::min(lowest_.y, p.y), std::min(lowest_.z, p.z)};
    highest_ = {std::max(highest_.x, p.x), std::max(highest_.y, p.y), std::max(highest_.z, p.z)};
  }
  const ElementsOfNode facets(mesh_.triangles, mesh_.points.size());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Triangle& corner = mesh_.triangles[t];
    const Facet& facet = tree_.facet(static_cast<int>(t));
    const auto& x = facet.corner;
    for (int k = 0; k < 3; ++k) {
      const Vec3 out = normalized(x[(k + 1) % 3] - x[k]), back = normalized(x[(k + 2) % 3] - x[k]);
      corner_normal_[corner[k]] += std::acos(std::clamp(dot(out, back), -1.0, 1.0)) * facet.normal;
    }
  }
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int from = mesh_.triangles[t][k], to = mesh_.triangles[t][(k + 1) % 3];
      const int other = facet_with_edge(mesh_.triangles, facets, to, from);
      Facet& here = tree_.facet(static_cast<int>(t));
      here.across[k] = other;
      edge_normal_[t][k] = here.normal;
      if (other < 0) {
        border_corner_[from] = border_corner_[to] = 1;
        continue;
      }
      const Facet& there = tree_.facet(other);
      edge_normal_[t][k] += there.normal;
      here.goes_on[k] = here.normal == there.normal && here.offset == there.offset;
    }
}

SurfacePoint ToolSurface::at(const Vec3& p, int facet, const FacetPoint& near) const
{
  SurfacePoint result;
  result.facet = facet;
  result.point = near.point;
  const Facet& f = tree_.facet(facet);
  const int edge = edge_number(near.feature);
  if (near.feature == Feature::inside || (edge >= 0 && goes_on(facet, edge))) return above(p, facet);
  Vec3 normal;
  if (edge >= 0) {
    normal = edge_normal_[facet][edge];
    result.on_border = f.across[edge] < 0;
  } else {
    const int node =
        mesh_.triangles[facet][static_cast<int>(near.feature) - static_cast<int>(Feature::corner_0)];
    normal = corner_normal_[node];
    result.on_border = border_corner_[node] != 0;
  }
  const Vec3 away = p - near.point;
  const double distance = std::sqrt(near.distance_squared);
  const double side = dot(away, normal) < 0.0 ? -1.0 : 1.0;
  result.distance = side * distance;
  // On the surface itself the shortest way has no direction: the facet's normal stands for it.
  constexpr double touching = 1e-12; // [m]
  result.normal = distance > touching ? (side / distance) * away : f.normal;
  return result;
}

SurfacePoint ToolSurface::above(const Vec3& p, int facet) const
{
  const Facet& f = tree_.facet(facet);
  SurfacePoint result;
  result.facet = facet;
  result.normal = f.normal;
  result.distance = f.height(p);
  result.point = p - result.distance * f.normal;
  result.inside = true;
  return result;
}

SurfacePoint ToolSurface::at(const Vec3& p, int facet) const
{
  return at(p, facet, nearest_on_facet(tree_.facet(facet), p));
}

SurfacePoint ToolSurface::nearest_of(const Vec3& p, int facet, int other) const
{
  const FacetPoint a = nearest_on_facet(tree_.facet(facet), p), b = nearest_on_facet(tree_.facet(other), p);
  const bool second = b.distance_squared < a.distance_squared ||
                      (b.distance_squared == a.distance_squared && other < facet);
  return second ? at(p, other, b) : at(p, facet, a);
}

SurfacePoint ToolSurface::nearest(const Vec3& p, int hint, double bound) const
{
  if (hint >= 0)
    bound =
        std::min(bound, std::sqrt(nearest_on_facet(tree_.facet(hint), p).distance_squared) * (1.0 + 1e-12));
  const int facet = tree_.nearest(p, std::min(bound, 1e100));
  if (facet < 0) return {};
  return at(p, facet);
}

} // namespace towform
