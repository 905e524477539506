#include "compare/comparison.hpp"
#include "compare/comparison_text.hpp"
#include "compare/made_sheets.hpp"
#include "mesh/msh_files.hpp"
#include "output/temporary_directory.hpp"

namespace towform {
namespace {

using Role = PointRole;

/// Points with the given roles; lines count from 2.
ReferencePoints points(const std::vector<Role>& roles, const std::vector<std::vector<double>>& rows)
{
  ReferencePoints p;
  p.file = "points.csv";
  p.header_line = 1;
  for (const Role role : roles) p.has[static_cast<std::size_t>(role)] = true;
  for (const auto& row : rows) {
    ReferencePoint point;
    point.line = 2 + static_cast<int>(p.points.size());
    for (std::size_t i = 0; i < roles.size(); ++i) point.values[static_cast<std::size_t>(roles[i])] = row[i];
    p.points.push_back(point);
  }
  return p;
}

std::vector<double> computed(const Comparison& c)
{
  std::vector<double> values;
  for (const ComparedPoint& p : c.points) values.push_back(p.computed.value_or(-99.0));
  return values;
}

const std::vector<Role> of_field{Role::x, Role::y, Role::shear}, of_outline{Role::x, Role::y},
    of_section{Role::arc, Role::shear}, of_sphere{Role::polar, Role::shear};

TEST(Comparison, OfAFieldIsExact)
{
  const SheetResult sheet = test::board(6, 4);
  // Shear is i + 10 j in the square (i, j).
  const ReferencePoints p =
      points(of_field, {{0.005, 0.002, 1.0}, {0.033, 0.015, 13.0}, {0.058, 0.039, 31.0}});
  const Comparison c = compare(sheet, p, {});
  EXPECT_EQ(c.kind, ComparisonKind::field);
  EXPECT_EQ(computed(c), (std::vector<double>{0.0, 13.0, 35.0}));
  EXPECT_DOUBLE_EQ(c.mean, (-1.0 + 0.0 + 4.0) / 3.0);
  EXPECT_DOUBLE_EQ(c.rms, std::sqrt((1.0 + 0.0 + 16.0) / 3.0));
  EXPECT_EQ(c.largest, 4.0);
  EXPECT_EQ(c.largest_line, 4);
  EXPECT_TRUE(c.failures.empty());
}

TEST(Comparison, BetweenMeansAtTheNodesALinearFieldIsExact)
{
  // The squares' values are those of x/10 mm - 1/2 + 10 (y/10 mm - 1/2) at their middles.
  const std::vector<std::vector<double>> places{
      {0.0123, 0.0171, 0.0}, {0.0337, 0.0152, 0.0}, {0.0421, 0.0269, 0.0}};
  ComparisonOptions options;
  options.nodal = true;
  const Comparison c = compare(test::board(6, 4), points(of_field, places), options);
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR(*c.points[i].computed, places[i][0] / 0.01 - 0.5 + 10.0 * (places[i][1] / 0.01 - 0.5), 1e-12);
  options.from = Vec2{0.01, 0.015};
  options.to = Vec2{0.05, 0.015};
  const Comparison along =
      compare(test::board(6, 4), points(of_section, {{0.0131, 0.0}, {0.029, 0.0}}), options);
  EXPECT_NEAR(*along.points[0].computed, 0.0231 / 0.01 - 0.5 + 10.0, 1e-9);
  EXPECT_NEAR(*along.points[1].computed, 0.039 / 0.01 - 0.5 + 10.0, 1e-9);
}

TEST(Comparison, JudgesByEveryPointAndByTheRootMeanSquare)
{
  const SheetResult sheet = test::board(6, 4);
  const ReferencePoints p = points(of_field, {{0.005, 0.002, 3.0}, {0.033, 0.015, 17.0}});
  ComparisonOptions o;
  o.tolerance = 4.0; // differences -3 and -4, RMS sqrt(12.5)
  o.rms = 3.54;
  EXPECT_TRUE(compare(sheet, p, o).failures.empty());
  o.tolerance = 3.99;
  ASSERT_EQ(compare(sheet, p, o).failures.size(), 1U);
  EXPECT_EQ(compare(sheet, p, o).failures[0], "largest difference 4 deg (line 3), limit 3.99 deg");
  o.rms = 3.53;
  ASSERT_EQ(compare(sheet, p, o).failures.size(), 2U);
  EXPECT_EQ(compare(sheet, p, o).failures[1], "RMS 3.536 deg, limit 3.53 deg");
}

TEST(Comparison, PointsOutsideTheSheetAreNamedAndFailOnceThereIsALimit)
{
  const SheetResult sheet = test::board(6, 4);
  const ReferencePoints p = points(of_field, {{0.005, 0.002, 0.0}, {0.07, 0.01, 0.0}, {-0.01, 0.01, 0.0}});
  const Comparison free = compare(sheet, p, {});
  EXPECT_EQ(free.compared, 1);
  EXPECT_TRUE(free.failures.empty());
  const std::string text = comparison_text(free, p, false);
  EXPECT_NE(text.find("outside the sheet"), std::string::npos);
  EXPECT_NE(text.find("1 of 3 points on the sheet"), std::string::npos) << text;
  ComparisonOptions o;
  o.tolerance = 1.0;
  const Comparison judged = compare(sheet, p, o);
  ASSERT_EQ(judged.failures.size(), 1U);
  EXPECT_EQ(judged.failures[0], "2 point(s) outside the sheet: line(s) 3, 4");
  // A comparison of nothing is no success.
  const Comparison nothing = compare(sheet, points(of_field, {{1.0, 1.0, 0.0}}), {});
  ASSERT_EQ(nothing.failures.size(), 1U);
  EXPECT_EQ(nothing.failures[0], "no point of the reference is on the sheet");
}

TEST(Comparison, SignsCountOnceTheReferenceHasThem)
{
  SheetResult sheet = test::board(6, 4);
  for (double& shear : sheet.shear) shear = -shear;
  const ReferencePoints positive = points(of_field, {{0.025, 0.002, 2.0}});
  EXPECT_TRUE(compare(sheet, positive, {}).magnitudes);
  EXPECT_EQ(compare(sheet, positive, {}).largest, 0.0);
  const ReferencePoints mixed = points(of_field, {{0.025, 0.002, 2.0}, {0.035, 0.002, -3.0}});
  const Comparison c = compare(sheet, mixed, {});
  EXPECT_FALSE(c.magnitudes);
  EXPECT_EQ(c.points[0].difference(), -4.0);
  EXPECT_EQ(c.points[1].difference(), 0.0);
}

TEST(Comparison, ReferenceCoordinatesArePlacesOnTheFlatSheet)
{
  SheetResult sheet = test::board(6, 4);
  for (Vec3& x : sheet.position) x = {x.x + 0.01, x.y, 0.1};
  const ReferencePoints p = points(of_field, {{0.025, 0.005, 0.0}});
  EXPECT_EQ(computed(compare(sheet, p, {})).front(), 1.0);
  ComparisonOptions o;
  o.reference_coordinates = true;
  EXPECT_EQ(computed(compare(sheet, p, o)).front(), 2.0);
}

TEST(Comparison, OfSeveralLayersTheHighestCountsOrTheNearestInSpace)
{
  SheetResult sheet = test::board(2, 1);
  // Square 1 is folded back over square 0, 10 mm above it.
  for (Vec3& x : sheet.position)
    if (x.x > 0.015) x = {0.0, x.y, 0.01};
  EXPECT_EQ(computed(compare(sheet, points(of_field, {{0.005, 0.002, 0.0}}), {})).front(), 1.0);
  const std::vector<Role> in_space{Role::x, Role::y, Role::z, Role::shear};
  const ReferencePoints p = points(in_space, {{0.005, 0.002, 0.0, 0.0}, {0.005, 0.002, 0.02, 0.0}});
  EXPECT_EQ(computed(compare(sheet, p, {})), (std::vector<double>{0.0, 1.0}));
}

TEST(Comparison, MirrorsFoldPointsIntoTheModelledPart)
{
  const ReferencePoints p =
      points(of_field,
             {{0.015, 0.025, 21.0}, {-0.015, 0.025, 21.0}, {-0.015, -0.025, -21.0}, {0.015, -0.025, 21.0}});
  ComparisonOptions o;
  o.mirror = true;
  const Comparison quarter = compare(test::board(6, 4), p, o);
  EXPECT_EQ(quarter.compared, 4);
  EXPECT_EQ(quarter.largest, 0.0); // by magnitude, whatever the reference's signs
  const Comparison half = compare(test::board(6, 4, {0.0, -0.01}), p, o); // y = 0 is no mirror of it
  EXPECT_EQ(half.compared, 2);
  EXPECT_EQ(compare(test::board(6, 4), p, {}).compared, 1);
  EXPECT_EQ(compare(test::board(6, 4), p, {}).hint,
            "the sheet ends at x = 0 and y = 0: if that is a mirror, --mirror folds points into it");
  EXPECT_EQ(quarter.hint, "");
  EXPECT_THROW(compare(test::board(6, 4, {-0.03, -0.02}), p, o), std::invalid_argument);
}

TEST(Comparison, OfAnOutlineIsExact)
{
  SheetResult sheet = test::board(6, 4);
  for (Vec3& x : sheet.position) x = {2.0 * x.x, x.y, x.x}; // 120 x 40 mm in plan
  const ReferencePoints p =
      points(of_outline,
             {{0.123, 0.02}, {0.115, 0.02}, {0.05, 0.04}, {0.123, 0.044}, {0.001, 0.03}, {-0.005, 0.02}});
  const Comparison c = compare(sheet, p, {});
  EXPECT_EQ(c.kind, ComparisonKind::outline);
  const std::vector<double> expected{-0.003, 0.005, 0.0, -0.005, 0.001, -0.005};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(c.points[i].difference(), expected[i], 1e-16) << i;
  // As a quarter: the sides on the mirrors are no outline.
  ComparisonOptions o;
  o.mirror = true;
  o.tolerance = 0.0049;
  const Comparison quarter = compare(sheet, p, o);
  EXPECT_NEAR(quarter.points[4].difference(), 0.01, 1e-16); // to y = 40 mm
  EXPECT_NEAR(quarter.points[5].difference(), 0.02, 1e-16);
  ASSERT_EQ(quarter.failures.size(), 1U);
  EXPECT_EQ(quarter.failures[0], "largest difference 20 mm (line 7), limit 4.9 mm");
}

TEST(Comparison, OfASectionGoesByTheLengthOverTheSheet)
{
  SheetResult sheet = test::board(6, 4);
  for (Vec3& x : sheet.position) x.z = 0.75 * x.x; // a slope: 5 along it for 4 in plan
  ComparisonOptions o;
  o.from = Vec2{0.0, 0.013};
  o.to = Vec2{0.06, 0.013};
  const ReferencePoints p =
      points(of_section, {{0.012, 10.0}, {0.013, 11.0}, {0.0749, 15.0}, {0.0751, 15.0}});
  const Comparison c = compare(sheet, p, o); // square i ends at an arc of 12.5 (i + 1) mm
  EXPECT_EQ(c.kind, ComparisonKind::section);
  EXPECT_EQ(computed(c), (std::vector<double>{10.0, 11.0, 15.0, -99.0}));
  o.reference_coordinates = true;
  EXPECT_EQ(computed(compare(sheet, p, o)), (std::vector<double>{11.0, 11.0, -99.0, -99.0}));
  // Between two rows of squares: the mean of both sides; on the outline the only one.
  o.reference_coordinates = false;
  o.from = Vec2{0.0, 0.02};
  o.to = Vec2{0.06, 0.02};
  EXPECT_EQ(computed(compare(sheet, p, o)).front(), 0.5 * (10.0 + 20.0));
  o.from = Vec2{0.0, 0.0};
  o.to = Vec2{0.06, 0.0};
  EXPECT_EQ(computed(compare(sheet, p, o)).front(), 0.0);
}

TEST(Comparison, OfALineOnASphereGoesByTheAngleAtItsCentre)
{
  const SheetResult sheet = test::cap(12);
  ComparisonOptions o;
  o.centre = Vec3{0.02, 0.03, 0.04};
  // 2.5, 7.5, … degrees lie in the rings 0, 1, …; a chord between two meridians lies up to 0.1 degrees lower.
  const ReferencePoints p =
      points(of_sphere, {{2.5, 0.0}, {7.5, 1.0}, {32.5, 6.0}, {57.5, 11.0}, {62.5, 12.0}});
  for (const Vec2 to : {Vec2{0.2, 0.03}, Vec2{0.2, 0.21}, Vec2{-0.13, 0.07}, Vec2{0.02, -0.3}}) {
    o.to = to;
    const Comparison c = compare(sheet, p, o);
    EXPECT_EQ(c.kind, ComparisonKind::sphere);
    EXPECT_EQ(computed(c), (std::vector<double>{0.0, 1.0, 6.0, 11.0, -99.0}));
    for (const ComparedPoint& point : c.points)
      if (point.computed) {
        EXPECT_NEAR(point.distance, 0.1, 0.002); // facets lie inside the sphere
      }
  }
  SheetResult above = sheet; // the same on top of the sphere
  for (Vec3& x : above.position) x.z = 0.08 - x.z;
  EXPECT_EQ(computed(compare(above, p, o)), (std::vector<double>{0.0, 1.0, 6.0, 11.0, -99.0}));
}

TEST(Comparison, SaysWhatColumnsAndOptionsMustGoTogether)
{
  const SheetResult sheet = test::board(6, 4);
  const auto refused = [&](const ReferencePoints& p, const ComparisonOptions& o) {
    return message_of<std::invalid_argument>([&] { compare(sheet, p, o); });
  };
  const ReferencePoints field = points(of_field, {{0, 0, 0}}), section = points(of_section, {{0, 0}}),
                        sphere = points(of_sphere, {{0, 0}});
  ComparisonOptions from, both, centre, line;
  from.from = line.from = Vec2{0, 0};
  line.to = centre.to = Vec2{0.01, 0};
  centre.centre = Vec3{};
  both = line;
  both.centre = Vec3{};
  EXPECT_EQ(refused(section, from), "a section needs both --from x,y and --to x,y");
  EXPECT_EQ(refused(section, {}), "column arc_mm needs --from x,y and --to x,y");
  EXPECT_EQ(refused(sphere, {}), "column polar_deg needs --centre x,y,z of the sphere and --to x,y");
  EXPECT_EQ(refused(sphere, both), "--centre and --from: a line starts at one of them");
  ComparisonOptions mirrored = line, flat = centre, point = line;
  mirrored.mirror = true;
  EXPECT_EQ(refused(section, mirrored),
            "--mirror folds points; draw the section in the part that is modelled");
  flat.reference_coordinates = true;
  EXPECT_EQ(refused(sphere, flat), "--reference-coordinates: the flat sheet lies on no sphere");
  point.to = point.from;
  EXPECT_EQ(refused(section, point), "--from and --to are one point");
  centre.to.reset();
  EXPECT_EQ(refused(sphere, centre), "--centre needs --to x,y, a plan point that the line runs towards");

  const auto file_refused = [&](const ReferencePoints& p, const ComparisonOptions& o) {
    return test::refusal([&] { compare(sheet, p, o); });
  };
  EXPECT_EQ(file_refused(field, line), "points.csv:1:1: --from needs a column arc_mm");
  EXPECT_EQ(file_refused(points({Role::arc}, {{0}}), line),
            "points.csv:1:1: a section needs a column shear_deg");
  centre.to = Vec2{0.01, 0};
  EXPECT_EQ(file_refused(section, centre), "points.csv:1:1: --centre needs a column polar_deg");
  EXPECT_TRUE(file_refused(points({Role::x, Role::shear}, {{0, 0}}), {})
                  .starts_with("points.csv:1:1: needs columns"));
}

TEST(Comparison, IsWrittenAsAFile)
{
  const SheetResult sheet = test::board(6, 4);
  const ReferencePoints p = points(of_field, {{0.005, 0.002, 1.0}, {0.07, 0.01, 2.0}});
  EXPECT_EQ(comparison_csv(compare(sheet, p, {}), p),
            "line,x_mm,y_mm,computed_deg,reference_deg,difference_deg\n"
            "2,5,2,0,1,-1\n3,70,10,,2,\n");
  const ReferencePoints outline = points(of_outline, {{0.055, 0.02}});
  EXPECT_EQ(comparison_csv(compare(sheet, outline, {}), outline),
            "line,x_mm,y_mm,difference_mm\n2,55,20,5\n");
}

} // namespace
} // namespace towform
