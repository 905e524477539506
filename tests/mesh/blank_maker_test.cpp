#include "flat_mesh_checks.hpp"
#include "towform/blank.hpp"
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace towform {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

BlankParameters double_dome()
{
  BlankParameters b;
  b.size = {0.65, 0.45};
  b.elements = 21706;
  b.thickness = 1e-3;
  return b;
}

void expect_refused(const BlankParameters& b, const std::string& what)
{
  try {
    make_blank(b);
    FAIL() << "accepted; expected: " << what;
  } catch (const std::invalid_argument& e) {
    EXPECT_EQ(std::string(e.what()), what);
  }
}

} // namespace

TEST(MakeBlank, MeetsTheWantedCountInEveryPatternAngleAndPart)
{
  for (const Pattern pattern : {Pattern::cross, Pattern::diagonal, Pattern::unstructured}) {
    for (const double fibre : {0.0, 45.0, 90.0}) {
      for (const double grid : {0.0, 30.0}) {
        for (const Symmetry symmetry : {Symmetry::none, Symmetry::x, Symmetry::y, Symmetry::quarter}) {
          BlankParameters b = double_dome();
          b.pattern = pattern;
          b.fibre_angle = fibre * degree;
          b.mesh_angle = grid * degree;
          b.symmetry = symmetry;
          const Blank blank = make_blank(b);
          const bool half_x = symmetry == Symmetry::x || symmetry == Symmetry::quarter;
          const bool half_y = symmetry == Symmetry::y || symmetry == Symmetry::quarter;
          const int parts = (half_x ? 2 : 1) * (half_y ? 2 : 1);
          EXPECT_NEAR(static_cast<double>(parts * blank.mesh.triangles.size()), 21706.0, 217.0);
          expect_fills_rectangle(blank.mesh, {half_x ? 0.0 : -0.325, half_y ? 0.0 : -0.225}, {0.325, 0.225});

          std::vector<int> at_x, at_y;
          for (int n = 0; n < static_cast<int>(blank.mesh.points.size()); ++n) {
            if (half_x && blank.mesh.points[n].x == 0.0) at_x.push_back(n);
            if (half_y && blank.mesh.points[n].y == 0.0) at_y.push_back(n);
          }
          EXPECT_EQ(blank.mirror_x, at_x);
          EXPECT_EQ(blank.mirror_y, at_y);
          EXPECT_EQ(at_x.size() > 10, half_x);
          EXPECT_EQ(at_y.size() > 10, half_y);
        }
      }
    }
  }
}

TEST(MakeBlank, MeetsAnyCountOverAThousandOnTurnedAndUnstructuredMeshes)
{
  for (const Pattern pattern : {Pattern::cross, Pattern::diagonal, Pattern::unstructured}) {
    for (const int elements : {1001, 1234, 3000, 9999, 50000}) {
      for (const double angle : {7.0, 45.0, 72.0}) {
        BlankParameters b = double_dome();
        b.elements = elements;
        b.pattern = pattern;
        b.mesh_angle = angle * degree;
        EXPECT_NEAR(static_cast<double>(make_blank(b).mesh.triangles.size()), elements, 0.01 * elements)
            << angle;
      }
    }
  }
}

TEST(MakeBlank, MeetsTheWantedEdge)
{
  BlankParameters b = double_dome();
  b.elements.reset();
  b.edge = 0.005;
  EXPECT_EQ(make_blank(b).mesh.triangles.size(), 2u * 130u * 90u);
  b.pattern = Pattern::cross;
  EXPECT_EQ(make_blank(b).mesh.triangles.size(), 4u * 130u * 90u);
  b.mesh_angle = 30 * degree;
  EXPECT_NEAR(static_cast<double>(make_blank(b).mesh.triangles.size()), 46800.0,
              936.0); // 1.5 % fewer: the sides
}

TEST(MakeBlank, YarnsFollowTheFibreAngle)
{
  BlankParameters b = double_dome();
  b.elements = 100;
  b.thickness = 2e-3;
  for (const double angle : {0.0, 10.0, 45.0, 77.0, 90.0, 180.0, -30.0, 270.0}) {
    b.fibre_angle = angle * degree;
    const Blank blank = make_blank(b);
    EXPECT_NEAR(blank.warp.x, std::cos(b.fibre_angle), 1e-15);
    EXPECT_NEAR(blank.warp.y, std::sin(b.fibre_angle), 1e-15);
    EXPECT_EQ(blank.weft, (Vec3{-blank.warp.y, blank.warp.x, 0.0}));
    EXPECT_EQ(blank.thickness, 2e-3);
  }
  b.fibre_angle = 90 * degree;
  EXPECT_EQ(make_blank(b).warp, (Vec3{0.0, 1.0, 0.0}));
  b.fibre_angle = -180 * degree;
  EXPECT_EQ(make_blank(b).warp, (Vec3{-1.0, 0.0, 0.0}));
}

TEST(MakeBlank, GridAngleCountsFromTheYarns)
{
  BlankParameters b = double_dome();
  const auto aligned = make_blank(b).mesh;
  b.fibre_angle = 45 * degree;
  b.mesh_angle = 45 * degree; // 90 degrees together: along the sides again
  EXPECT_EQ(make_blank(b).mesh.points, aligned.points);
  b.mesh_angle = -45 * degree;
  EXPECT_EQ(make_blank(b).mesh.triangles, aligned.triangles);
  b.mesh_angle = 0.0;
  EXPECT_NE(make_blank(b).mesh.points.size(), aligned.points.size());
}

TEST(MakeBlank, TheQuarterIsAQuarterOfTheWholeToTheBit)
{
  for (const Pattern pattern : {Pattern::cross, Pattern::diagonal}) {
    BlankParameters b = double_dome();
    b.pattern = pattern;
    const auto whole = placed_triangles(make_blank(b).mesh);
    b.symmetry = Symmetry::quarter;
    const auto part = placed_triangles(make_blank(b).mesh);
    EXPECT_EQ(4 * part.size(), whole.size());
    EXPECT_TRUE(std::includes(whole.begin(), whole.end(), part.begin(), part.end()));
  }
}

TEST(MakeBlank, NumbersNeighboursClose)
{
  for (const Pattern pattern : {Pattern::cross, Pattern::diagonal, Pattern::unstructured}) {
    BlankParameters b = double_dome();
    b.pattern = pattern;
    const SurfaceMesh mesh = make_blank(b).mesh;
    std::vector<int> spans;
    for (const Triangle& t : mesh.triangles) spans.push_back(std::max(t[1], t[2]) - t[0]);
    std::nth_element(spans.begin(), spans.begin() + spans.size() / 2, spans.end());
    EXPECT_LT(spans[spans.size() / 2], 40); // of 11,000 nodes
  }
}

TEST(MakeBlank, TakesAsFewAsTwoElements)
{
  BlankParameters b = double_dome();
  b.elements = 2;
  EXPECT_EQ(make_blank(b).mesh.triangles.size(), 8u); // a line on either centre line
  b.mesh_angle = 0.3;
  EXPECT_EQ(make_blank(b).mesh.triangles.size(), 2u);
  b.pattern = Pattern::unstructured;
  EXPECT_EQ(make_blank(b).mesh.triangles.size(), 2u);
}

TEST(MakeBlank, RefusesContradictionsInWordsForTheUser)
{
  BlankParameters b = double_dome();
  b.edge = 0.005;
  expect_refused(b, "the blank has both a number of elements and an edge; give one of them");
  b.elements.reset();
  b.edge.reset();
  expect_refused(b, "the blank has no mesh size; give the number of elements or the edge");
  b.edge = -0.005;
  expect_refused(b, "the edge of the blank's elements must be a positive length; it is -0.005 m");
  b.edge = 1e-5;
  expect_refused(
      b, "the blank would have 5.85e+09 elements; the limit is 2e+07: ask for fewer or for longer edges");
  b.edge = 1e-300;
  EXPECT_THROW(make_blank(b), std::invalid_argument);

  b = double_dome();
  b.elements = 20000001;
  EXPECT_THROW(make_blank(b), std::invalid_argument);
  b.elements = 1;
  expect_refused(b, "a blank needs at least 2 elements; 1 were asked for");

  b = double_dome();
  b.size.y = 0.0;
  expect_refused(b, "both sides of the blank must be positive lengths; they are 0.65 m and 0 m");
  b.size = {std::numeric_limits<double>::infinity(), 1.0};
  EXPECT_THROW(make_blank(b), std::invalid_argument);
  b.size = {30.0, 0.001};
  expect_refused(b, "the blank is 30000 times as long as it is wide; 10000 times is the limit");

  b = double_dome();
  b.fibre_angle = std::nan("");
  expect_refused(b, "the fibre angle and the mesh angle of the blank must be finite");
  b = double_dome();
  b.thickness = -1.0;
  expect_refused(b, "the thickness of the blank must be a positive length; it is -1 m");

  b = double_dome();
  b.symmetry = Symmetry::quarter;
  b.fibre_angle = 30 * degree;
  expect_refused(
      b, "a blank with symmetry needs a fibre angle of 0, 45 or 90 degrees, not 30: its yarns are not "
         "their own mirror image; mesh the whole blank");
}

} // namespace towform
