#pragma once
#include "towform/surface_mesh.hpp"
#include <array>
#include <span>
#include <vector>

namespace towform {

/// Edges that belong to one triangle only, each in that triangle's direction: outline and holes. Ascending.
std::vector<std::array<int, 2>> outline_edges(std::span<const Triangle> triangles);

/// A place on an edge of the outline: (1 - share) of its first node and share of its second.
struct OutlinePoint {
  std::array<int, 2> nodes{};
  double share = 0.0;

  [[nodiscard]] Vec3 at(std::span<const Vec3> position) const
  {
    return (1.0 - share) * position[nodes[0]] + share * position[nodes[1]];
  }
};

/// Where a ray from `from` towards `to` in plan crosses the edges last; one that meets none takes the node
/// nearest to `to`. There must be an edge.
OutlinePoint last_crossing(std::span<const std::array<int, 2>> edges, std::span<const Vec3> position,
                           Vec2 from, Vec2 to);

} // namespace towform
