#include "mesh/flat_mesh_checks.hpp"
#include "mesh/imported_blank.hpp"
#include "mesh/msh_files.hpp"
#include "mesh/outline.hpp"
#include "output/temporary_directory.hpp"
#include <numeric>
#include <random>

namespace towform {
namespace {

SurfaceMesh import(const std::vector<Vec3>& nodes, const std::vector<std::vector<int>>& elements)
{
  return triangles_of(parse_msh(test::msh(nodes, elements), "blank.msh", 1.0), "blank.msh");
}

std::string refused(const std::vector<Vec3>& nodes, const std::vector<std::vector<int>>& elements)
{
  return test::refusal([&] { import(nodes, elements); });
}

const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(ImportedBlank, TurnsEveryElementUp)
{
  for (const auto& elements : std::vector<std::vector<std::vector<int>>>{{{1, 2, 3}, {1, 3, 4}},
                                                                         {{1, 3, 2}, {1, 3, 4}},
                                                                         {{1, 3, 2}, {4, 3, 1}},
                                                                         {{1, 2, 3, 4}},
                                                                         {{4, 3, 2, 1}}}) {
    const SurfaceMesh mesh = import(square, elements);
    expect_fills_rectangle(mesh, {0, 0}, {1, 1});
  }
}

TEST(ImportedBlank, CutsQuadrilateralsWhereTheTrianglesAreBest)
{
  // A kite: along its axis from (0, 0) to (4, 0) the smallest angle is larger than across it, though the
  // diagonal is longer.
  const std::vector<Vec3> kite{{0, 0, 0}, {1, -1.6, 0}, {4, 0, 0}, {1, 1.6, 0}};
  const SurfaceMesh along = import(kite, {{1, 2, 3, 4}});
  const auto edge_of = [](const SurfaceMesh& mesh, int a, int b) {
    return std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
      return std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
    });
  };
  const auto smallest = [&](int a, int b, int c, int d) { // both triangles on the diagonal a c
    return smallest_angle({kite, {{a, b, c}, {a, c, d}}});
  };
  const bool axis_is_better = smallest(0, 1, 2, 3) > smallest(1, 2, 3, 0);
  EXPECT_EQ(edge_of(along, 0, 2) == 2, axis_is_better);
  EXPECT_EQ(smallest_angle(along), std::max(smallest(0, 1, 2, 3), smallest(1, 2, 3, 0)));

  // Not convex: one diagonal runs outside.
  const std::vector<Vec3> arrow{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
  for (const auto& element : std::vector<std::vector<int>>{{1, 2, 3, 4}, {2, 3, 4, 1}, {4, 3, 2, 1}}) {
    const SurfaceMesh mesh = import(arrow, {element});
    EXPECT_EQ(edge_of(mesh, 0, 2), 2);
    EXPECT_GT(signed_area(mesh, mesh.triangles[0]), 0.0);
    EXPECT_GT(signed_area(mesh, mesh.triangles[1]), 0.0);
  }
}

TEST(ImportedBlank, CutsSquaresSoThatAMirrorImageStaysOne)
{
  std::vector<Vec3> nodes;
  std::vector<std::vector<int>> quads;
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) nodes.push_back({double(i), double(j), 0.0});
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      std::vector<int> q{5 * j + i + 1, 5 * j + i + 2, 5 * j + i + 7, 5 * j + i + 6};
      std::rotate(q.begin(), q.begin() + (i + 2 * j) % 4, q.end()); // whichever node comes first
      quads.push_back(q);
    }
  const SurfaceMesh mesh = import(nodes, quads);
  EXPECT_EQ(placed_triangles(mesh), placed_triangles(mesh, -1.0, 1.0));
  EXPECT_EQ(placed_triangles(mesh), placed_triangles(mesh, 1.0, -1.0));
}

TEST(ImportedBlank, KeepsHolesAndItsPlane)
{
  // A square ring of eight quadrilaterals at z = 0.25.
  std::vector<Vec3> nodes;
  std::vector<std::vector<int>> quads;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) nodes.push_back({double(i), double(j), 0.25 + 1e-9 * i});
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      if (i != 1 || j != 1) quads.push_back({4 * j + i + 1, 4 * j + i + 2, 4 * j + i + 6, 4 * j + i + 5});
  const SurfaceMesh mesh = import(nodes, quads);
  EXPECT_EQ(mesh.triangles.size(), 16U);
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) area += signed_area(mesh, t);
  EXPECT_DOUBLE_EQ(area, 8.0);
  for (const Vec3& p : mesh.points) EXPECT_EQ(p.z, mesh.points[0].z);
  EXPECT_EQ(outline_edges(mesh.triangles).size(), 12U + 4U);
}

TEST(ImportedBlank, RefusesWhatIsNoSheet)
{
  const auto expect = [](const std::string& said, const std::string& place, const std::string& message) {
    EXPECT_TRUE(said.starts_with("blank.msh:" + place + ":1: ")) << said;
    EXPECT_NE(said.find(message), std::string::npos) << said;
  };
  std::vector<Vec3> nodes = square;
  nodes[2].z = 1e-3;
  expect(refused(nodes, {{1, 2, 3}, {1, 3, 4}}), "13",
         "the blank is not flat: node 3 is at z = 1 mm and node 1 at 0 mm");
  std::vector<Vec3> slit = square;
  slit.push_back({1.0, 1e-9, 0.0});
  expect(refused(slit, {{1, 2, 3}, {1, 3, 4}, {5, 3, 4}}), "16", "node 5 lies where node 2 (line 13) does");
  std::vector<Vec3> line = square;
  line.push_back({0.5, 0, 0});
  expect(refused(line, {{1, 5, 2}, {1, 2, 3}}), "21",
         "triangle 1 has no area or repeats a node (1 such in all)");
  expect(refused(square, {{1, 2, 3}, {1, 3, 3}}), "21", "triangle 2 has no area or repeats a node");
  expect(refused(square, {{1, 2, 4, 3}}), "19", "quadrilateral 1 has no area or crosses itself");
  expect(refused(square, {{1, 2, 2, 4}}), "19", "quadrilateral 1 has no area or");
  expect(refused(square, {{1, 2, 3}, {3, 1, 2}}), "21", "triangle 2 has the nodes of triangle 1 (line 19)");
  expect(refused(square, {{1, 2, 3, 4}, {1, 2, 3}}), "21",
         "triangle 2 has the nodes of quadrilateral 1 (line 19)");
  expect(refused(square, {{1, 2, 3}, {1, 2, 4}}), "19", "lie on the same side of the edge they share");
  expect(refused(line, {{1, 2, 3}, {1, 3, 4}, {1, 5, 3}}), "21", "shares an edge with more than one other");
  std::vector<Vec3> huge = square;
  for (Vec3& p : huge) p *= 1e6;
  expect(refused(huge, {{1, 2, 3}}), "11", "the blank would be 1e+06 m wide: is blank.mesh_unit right?");
}

class ImportedFile : public TemporaryDirectory {
protected:
  BlankParameters parameters(const SurfaceMesh& mesh) const
  {
    std::ofstream(directory / "blank.msh") << test::msh(mesh);
    BlankParameters p;
    p.mesh = directory / "blank.msh";
    p.thickness = 1e-3;
    return p;
  }
};

BlankParameters rectangle(Symmetry symmetry = Symmetry::none)
{
  BlankParameters p;
  p.size = {0.3, 0.2};
  p.elements = 600;
  p.thickness = 1e-3;
  p.symmetry = symmetry;
  return p;
}

TEST_F(ImportedFile, IsNumberedAsAGeneratedBlankIs)
{
  const Blank made = make_blank(rectangle());
  SurfaceMesh shuffled = made.mesh;
  std::vector<int> number(made.mesh.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(6);
  std::shuffle(number.begin(), number.end(), random);
  for (std::size_t k = 0; k < number.size(); ++k) shuffled.points[number[k]] = made.mesh.points[k];
  for (Triangle& t : shuffled.triangles) t = {number[t[1]], number[t[0]], number[t[2]]}; // turned over, too
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);

  const Blank imported = make_blank(parameters(shuffled));
  EXPECT_EQ(imported.mesh.points, made.mesh.points);
  EXPECT_EQ(imported.mesh.triangles, made.mesh.triangles);
  EXPECT_EQ(imported.warp, made.warp);
  EXPECT_EQ(imported.weft, made.weft);
}

TEST_F(ImportedFile, MirrorsHoldTheNodesOnThem)
{
  for (const Symmetry symmetry : {Symmetry::x, Symmetry::y, Symmetry::quarter}) {
    const Blank made = make_blank(rectangle(symmetry));
    SurfaceMesh noisy = made.mesh; // as a mesher leaves it
    for (const int n : made.mirror_x) noisy.points[n].x = 3e-12;
    for (const int n : made.mirror_y) noisy.points[n].y = -2e-12;
    BlankParameters p = parameters(noisy);
    p.symmetry = symmetry;
    const Blank imported = make_blank(p);
    EXPECT_EQ(imported.mirror_x.size(), made.mirror_x.size());
    EXPECT_EQ(imported.mirror_y.size(), made.mirror_y.size());
    EXPECT_EQ(placed_triangles(imported.mesh), placed_triangles(made.mesh));
  }
}

TEST_F(ImportedFile, HasToLieOnOneSideOfAMirrorAndReachIt)
{
  BlankParameters p = parameters(make_blank(rectangle()).mesh);
  p.symmetry = Symmetry::x;
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              make_blank(p);
            }).find("blank.symmetry keeps x >= 0, but the mesh reaches to x = -150 mm"),
            std::string::npos);
  SurfaceMesh apart = make_blank(rectangle(Symmetry::quarter)).mesh;
  for (Vec3& x : apart.points) x.y += 1e-3;
  p = parameters(apart);
  p.symmetry = Symmetry::quarter;
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              make_blank(p);
            }).find("blank.symmetry makes y = 0 a mirror, but the mesh begins at y = 1 mm"),
            std::string::npos);
}

TEST_F(ImportedFile, YarnsGoTheGivenWays)
{
  BlankParameters p = parameters(make_blank(rectangle(Symmetry::quarter)).mesh);
  p.fibre_1 = Vec3{3, 4, 0};
  p.fibre_2 = Vec3{-5, 0, 0};
  const Blank blank = make_blank(p);
  EXPECT_EQ(blank.warp, (Vec3{3.0 / 5.0, 4.0 / 5.0, 0}));
  EXPECT_EQ(blank.weft, (Vec3{-1, 0, 0}));
  p.symmetry = Symmetry::quarter;
  EXPECT_NE(
      message_of<std::invalid_argument>([&] { make_blank(p); }).find("which fibre_1 and fibre_2 are not"),
      std::string::npos);
  p.fibre_2 = Vec3{-3, 4, 0}; // the mirror image of fibre_1
  EXPECT_NO_THROW(make_blank(p));
}

TEST_F(ImportedFile, ReadsWhatGmshWrites)
{
  BlankParameters p;
  p.mesh = std::filesystem::path(TOWFORM_SOURCE_DIR) / "tests/mesh/plate_with_hole.msh";
  p.mesh_unit = 1e-3;
  p.thickness = 1e-3;
  const Blank blank = make_blank(p);
  double area = 0.0;
  for (const Triangle& t : blank.mesh.triangles) area += signed_area(blank.mesh, t);
  // 120 x 80 mm less a hole of 20 mm radius, whose 32 sides on the circle leave a little more.
  const double hole = 0.5 * 32 * std::sin(2 * M_PI / 32) * 0.02 * 0.02;
  EXPECT_NEAR(area, 0.12 * 0.08 - hole, 1e-9);
  for (const auto& [a, b] : outline_edges(blank.mesh.triangles)) {
    const Vec3 middle = 0.5 * (blank.mesh.points[a] + blank.mesh.points[b]);
    const bool on_hole = std::abs(std::hypot(middle.x, middle.y) - 0.02) < 2e-4;
    const bool on_side =
        std::abs(std::abs(middle.x) - 0.06) < 1e-12 || std::abs(std::abs(middle.y) - 0.04) < 1e-12;
    EXPECT_TRUE(on_hole || on_side) << middle.x << ' ' << middle.y;
  }
}

} // namespace
} // namespace towform
