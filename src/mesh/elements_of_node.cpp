#include "mesh/elements_of_node.hpp"

namespace towform {

ElementsOfNode::ElementsOfNode(std::span<const Triangle> triangles, std::size_t nodes)
    : first(nodes + 1, 0), element(3 * triangles.size())
{
  for (const Triangle& t : triangles)
    for (const int node : t) ++first[static_cast<std::size_t>(node) + 1];
  for (std::size_t i = 0; i < nodes; ++i) first[i + 1] += first[i];
  std::vector<int> next(first.begin(), first.end() - 1);
  for (std::size_t e = 0; e < triangles.size(); ++e)
    for (const int node : triangles[e]) element[next[node]++] = static_cast<int>(e);
}

} // namespace towform
