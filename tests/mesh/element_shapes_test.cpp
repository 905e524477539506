#include "mesh/blank_grid.hpp"
#include "mesh/blank_lattice.hpp"
#include "mesh/element_shapes.hpp"
#include "mesh/renumber.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace towform {

namespace {
/// Corners 1 and 2 seen from corner 0.
std::array<Vec3, 2> edges(const SurfaceMesh& mesh, std::size_t element)
{
  const auto& [a, b, c] = mesh.triangles[element];
  return {mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]};
}
} // namespace

TEST(ElementShapes, OfARegularMeshAreFew)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {126, 86}, Pattern::diagonal, Symmetry::none);
  renumber(mesh); // which lets all of a shape begin with the same corner
  const std::vector<int> shape = element_shapes(mesh);
  EXPECT_EQ(std::set<int>(shape.begin(), shape.end()), (std::set<int>{0, 1, 2, 3}));
  for (std::size_t e = 0; e < shape.size(); ++e) {
    const auto same = static_cast<std::size_t>(std::find(shape.begin(), shape.end(), shape[e]) - shape.begin());
    const auto here = edges(mesh, e), there = edges(mesh, same);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(norm(here[k] - there[k]), 1e-14);
  }
}

TEST(ElementShapes, ThatAreAlmostTheSameAreTwo)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {126, 86}, Pattern::diagonal, Symmetry::quarter);
  renumber(mesh);
  const std::vector<int> before = element_shapes(mesh);
  for (Vec3& p : mesh.points)
    if (p.x > 0.16) p.x += 1e-8 * (p.x - 0.16); // edges there are longer by a part in 1e8
  const std::vector<int> after = element_shapes(mesh);
  EXPECT_GT(*std::max_element(after.begin(), after.end()), *std::max_element(before.begin(), before.end()));
}

TEST(ElementShapes, OfAnUnstructuredMeshAreEachItsOwn)
{
  const SurfaceMesh mesh = unstructured_mesh({{-0.1, -0.1}, {0.12, 0.1}}, 0.006);
  const std::vector<int> shape = element_shapes(mesh);
  EXPECT_LT(std::count_if(shape.begin(), shape.end(), [](int s) { return s >= 0; }), std::ptrdiff_t(shape.size()) / 2);
}

TEST(Renumber, BringsTogetherWhatHasOneShape)
{
  SurfaceMesh mesh = aligned_grid({0.65, 0.45}, {126, 86}, Pattern::diagonal, Symmetry::none);
  const std::size_t tiles = renumber(mesh).triangles.size();
  const std::vector<int> shape = element_shapes(mesh);
  std::size_t changes = 0;
  for (std::size_t e = 1; e < shape.size(); ++e) changes += shape[e] != shape[e - 1] ? 1 : 0;
  EXPECT_LT(changes, 12 * tiles);
}

} // namespace towform
