#include "mesh/msh_files.hpp"
#include "output/temporary_directory.hpp"
#include "solver/bare_sheet.hpp"
#include "solver/frame_fields.hpp"
#include "solver/measure.hpp"
#include "solver/specimen.hpp"
#include <fstream>

namespace towform {
namespace {

class ImportedBlankCase : public TemporaryDirectory {
protected:
  /// The bare sheet with another blank.
  Case with(const std::string& mesh) const
  {
    std::ofstream(directory / "blank.msh") << mesh;
    Case c = test::bare_sheet();
    c.blank = {};
    c.blank.mesh = directory / "blank.msh";
    c.blank.thickness = 1e-3;
    return c;
  }
  Case with(const SurfaceMesh& mesh) const { return with(test::msh(mesh)); }
};

TEST_F(ImportedBlankCase, MovesAsTheSameBlankMadeHere)
{
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::quarter}) {
    Case made = test::bare_sheet();
    made.blank.symmetry = symmetry;
    const Model model = build_model(made);
    Case c = with(model.blank.mesh);
    c.blank.symmetry = symmetry;
    const Model imported = build_model(c);
    const auto moved = [](const Model& m) {
      System s = start(m);
      test::shake(s, 1.0);
      test::step_on(m, s, m.first_step, 50);
      return s.sheet.position;
    };
    EXPECT_EQ(moved(imported), moved(model)); // the same bits
    EXPECT_EQ(imported.mirror_factor, model.mirror_factor);
  }
}

TEST_F(ImportedBlankCase, AMeshThatIsUnfitIsAnIssueWithItsLineBesideOthers)
{
  Case c = with(std::string("$MeshFormat\n2.2 0 8\n"));
  c.material.constituents.fibre_volume_fraction = 0.0;
  try {
    build_model(c);
    FAIL();
  } catch (const InputError& e) {
    ASSERT_EQ(e.issues().size(), 2U);
    EXPECT_EQ(e.issues()[0].where.line, 2);
    EXPECT_EQ(e.issues()[0].where.file, (directory / "blank.msh").string());
    EXPECT_EQ(e.issues()[0].code, ExitCode::files);
  }
}

/// A plate of unit squares, 12 x 8 of them 10 mm wide, those left out that `hole` names, its middle at
/// `middle`.
template <class Hole>
SurfaceMesh plate(Vec2 middle, Hole hole)
{
  SurfaceMesh mesh;
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 12; ++i)
      mesh.points.push_back({middle.x + 0.01 * (i - 6), middle.y + 0.01 * (j - 4), 0.0});
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 12; ++i) {
      if (hole(i, j)) continue;
      const int a = 13 * j + i;
      mesh.triangles.push_back({a, a + 1, a + 14});
      mesh.triangles.push_back({a, a + 14, a + 13});
    }
  return mesh;
}

/// Draw-in when every point goes a tenth of the way to the middle in x and a fifth in y.
DrawIn drawn(const Case& c, Vec2 middle)
{
  const Model model = build_model(c);
  System s = start(model);
  for (Vec3& x : s.sheet.position)
    x = {middle.x + 0.9 * (x.x - middle.x), middle.y + 0.8 * (x.y - middle.y), x.z};
  return DrawInGauge(model.blank).measure(s);
}

TEST_F(ImportedBlankCase, DrawInIsThatOfTheOutline)
{
  const auto whole = [](int, int) { return false; };
  const auto ring = [](int i, int j) { return i > 3 && i < 8 && j > 2 && j < 5; };
  const auto shape_l = [](int i, int j) { return i > 2 && j > 2; };
  const double corner = std::hypot(0.06, 0.04) - std::hypot(0.054, 0.032);
  for (const Vec2 middle : {Vec2{0, 0}, Vec2{0.3, -0.2}}) {
    for (const bool with_hole : {false, true}) {
      const DrawIn d = drawn(with(with_hole ? plate(middle, ring) : plate(middle, whole)), middle);
      EXPECT_NEAR(d.x_mid, 0.006, 1e-12);
      EXPECT_NEAR(d.y_mid, 0.008, 1e-12);
      EXPECT_NEAR(d.corner, corner, 1e-12);
    }
    // An L: nothing at the right of the middle, above it and towards the upper right corner; the nearest
    // nodes of the outline stand for those: (120, 30), (30, 80) and one of them.
    const DrawIn d = drawn(with(plate(middle, shape_l)), middle);
    EXPECT_NEAR(d.x_mid, 0.006, 1e-12);
    EXPECT_NEAR(d.y_mid, 0.008, 1e-12);
    EXPECT_GT(d.corner, 0.005);
    EXPECT_LT(d.corner, corner + 1e-12);
  }
}

TEST_F(ImportedBlankCase, DrawInOfADiscIsTheSameAllRound)
{
  // Rings of eight nodes about the middle: the rays to the corners of the box meet the outline on the circle.
  SurfaceMesh disc;
  disc.points.push_back({0, 0, 0});
  for (int i = 0; i < 64; ++i)
    disc.points.push_back({0.1 * std::cos(2 * M_PI * i / 64), 0.1 * std::sin(2 * M_PI * i / 64), 0.0});
  for (int i = 0; i < 64; ++i) disc.triangles.push_back({0, 1 + i, 1 + (i + 1) % 64});
  const Model model = build_model(with(disc));
  System s = start(model);
  for (Vec3& x : s.sheet.position) x *= 0.75;
  const DrawIn d = DrawInGauge(model.blank).measure(s);
  EXPECT_NEAR(d.x_mid, 0.025, 1e-12);
  EXPECT_NEAR(d.y_mid, 0.025, 1e-12);
  EXPECT_NEAR(d.corner, 0.025, 1e-12);
}

TEST_F(ImportedBlankCase, GripsHoldTheNodesOnASideOfItsBox)
{
  SurfaceMesh mesh = plate({0.1, 0.0}, [](int, int) { return false; });
  for (Vec3& p : mesh.points) p.x += p.y == 0.0 ? 1e-9 : 0.0; // as exact as a mesher is
  Case c = with(mesh);
  c = test::gripped(c, test::Edge::left, test::Edge::right, test::moving(Axis::x, 1e-3, c.time.end));
  const Model model = build_model(c);
  for (const Boundary& b : model.boundaries) {
    EXPECT_EQ(b.nodes.size(), 9U);
    for (const Vec3& x : b.start) EXPECT_NEAR(x.x, b.motion ? 0.16 : 0.04, 2e-9);
  }
}

TEST_F(ImportedBlankCase, AGripNeedsAnEdge)
{
  SurfaceMesh mesh{{{0, 0, 0}, {0.1, -0.05, 0}, {0.1, 0.05, 0}}, {{0, 1, 2}}};
  Case c = with(mesh);
  c = test::gripped(c, test::Edge::left, test::Edge::right, test::moving(Axis::x, 1e-3, c.time.end));
  const std::string said = message_of<InputError>([&] { build_model(c); });
  EXPECT_NE(said.find("boundary.foot: the mesh has one node only on that side"), std::string::npos) << said;
}

TEST_F(ImportedBlankCase, ThicknessOfObliqueYarnsStartsAsGiven)
{
  Case c = with(plate({0, 0}, [](int, int) { return false; }));
  c.blank.fibre_1 = Vec3{1, 0, 0};
  c.blank.fibre_2 = Vec3{1, 2, 0};
  const Model model = build_model(c);
  System s = start(model);
  const CurvatureOperator curvature(model.blank, {}, 0);
  for (const double h : frame_field(model, s, curvature, "thickness").thickness) EXPECT_NEAR(h, 1e-3, 1e-15);
  for (Vec3& x : s.sheet.position) x = {1.25 * x.x, 1.6 * x.y, 0.0}; // twice the area
  evaluate_forces(model, s, model.first_step, *std::make_unique<Phases>());
  for (const double h : frame_field(model, s, curvature, "thickness").thickness) EXPECT_NEAR(h, 0.5e-3, 1e-15);
}

} // namespace
} // namespace towform
