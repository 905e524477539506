#include "flat_mesh_checks.hpp"
#include "mesh/blank_lattice.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace towform {

TEST(UnstructuredMesh, FillsTheRectangleWithGoodTriangles)
{
  constexpr double degree = std::numbers::pi / 180.0;
  const Rectangle sheets[] = {
      {{-0.325, -0.225}, {0.325, 0.225}}, {{0.0, 0.0}, {0.15, 0.15}}, {{-2, -0.02}, {2, 0.02}}};
  for (const Rectangle& sheet : sheets) {
    for (const double edge : {0.05, 0.02, 0.008, 0.004}) {
      const SurfaceMesh mesh = unstructured_mesh(sheet, edge);
      expect_fills_rectangle(mesh, sheet.low, sheet.high);
      EXPECT_EQ(static_cast<std::int64_t>(mesh.triangles.size()), count_unstructured_mesh(sheet, edge));
      RecordProperty("smallest_angle_" + std::to_string(mesh.triangles.size()),
                     std::to_string(smallest_angle(mesh) / degree));
      EXPECT_GT(smallest_angle(mesh), 25.0 * degree) << edge << " " << mesh.triangles.size();
    }
  }
}

TEST(UnstructuredMesh, HasEdgesInAllDirections)
{
  const Rectangle sheet{{-0.5, -0.5}, {0.5, 0.5}};
  const SurfaceMesh mesh = unstructured_mesh(sheet, 0.02);
  std::array<int, 12> directions{};
  int edges = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const double turn = std::atan2(d.y, d.x) / std::numbers::pi + 1.0;
      ++directions[static_cast<int>(12.0 * turn) % 12];
      ++edges;
    }
  }
  // A lattice alone would leave half of the twelve sectors empty.
  EXPECT_GT(*std::min_element(directions.begin(), directions.end()), edges / 12 / 5);
}

TEST(UnstructuredMesh, IsTheSameEveryTime)
{
  const Rectangle sheet{{-0.3, -0.2}, {0.3, 0.2}};
  const SurfaceMesh a = unstructured_mesh(sheet, 0.02), b = unstructured_mesh(sheet, 0.02);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

} // namespace towform
