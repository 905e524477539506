#pragma once
#include "towform/error.hpp"
#include "towform/surface_mesh.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace towform::test {

/// A Gmsh file, one node or element a line, tags from 1; elements of three or four nodes.
inline std::string msh(const std::vector<Vec3>& nodes, const std::vector<std::vector<int>>& elements)
{
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n";
  text += fmt::format("1 {0} 1 {0}\n2 1 0 {0}\n", nodes.size());
  for (std::size_t n = 1; n <= nodes.size(); ++n) text += fmt::format("{}\n", n);
  for (const Vec3& x : nodes) text += fmt::format("{:.17g} {:.17g} {:.17g}\n", x.x, x.y, x.z);
  text += fmt::format("$EndNodes\n$Elements\n{0} {0} 1 {0}\n", elements.size());
  int tag = 0;
  for (const std::vector<int>& e : elements) { // a block each: kinds may follow in any order
    text += fmt::format("2 1 {} 1\n{}", e.size() == 3 ? 2 : 3, ++tag);
    for (const int n : e) text += fmt::format(" {}", n);
    text += "\n";
  }
  return text + "$EndElements\n";
}

inline std::string msh(const SurfaceMesh& mesh)
{
  std::vector<std::vector<int>> elements;
  for (const Triangle& t : mesh.triangles) elements.push_back({t[0] + 1, t[1] + 1, t[2] + 1});
  return msh(mesh.points, elements);
}

/// "file:line:column: message" of the InputError that an action throws, which must be one of a file.
template <class Action>
std::string refusal(Action action)
{
  try {
    action();
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), ExitCode::files);
    EXPECT_EQ(error.issues().size(), 1U);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

} // namespace towform::test
