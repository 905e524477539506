#pragma once
#include "towform/surface_mesh.hpp"
#include <span>
#include <vector>

namespace towform {

/// The elements round every node, ascending, so that sums have one order.
struct ElementsOfNode {
  std::vector<int> first;   ///< n + 1
  std::vector<int> element; ///< 3m

  ElementsOfNode(std::span<const Triangle> triangles, std::size_t nodes);
  [[nodiscard]] std::span<const int> of(std::size_t node) const
  {
    return {element.data() + first[node], element.data() + first[node + 1]};
  }
};

} // namespace towform
