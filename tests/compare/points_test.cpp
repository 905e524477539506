#include "compare/condition.hpp"
#include "compare/point_columns.hpp"
#include "mesh/msh_files.hpp"
#include "output/temporary_directory.hpp"

namespace towform {
namespace {

class Points : public TemporaryDirectory {
protected:
  PointTable table(const std::string& text) const
  {
    std::ofstream(directory / "points.csv", std::ios::binary) << text;
    return read_points(directory / "points.csv");
  }
  PointTable chosen(const std::string& text, const std::vector<std::string>& conditions) const
  {
    PointTable t = table(text);
    std::vector<Condition> all;
    for (const std::string& condition : conditions) all.push_back(read_condition(condition));
    keep_rows(t, all);
    return t;
  }
  ReferencePoints read(const std::string& text, const std::vector<std::string>& columns = {}) const
  {
    std::vector<ColumnChoice> choices;
    for (const std::string& column : columns) choices.push_back(read_column_choice(column));
    return read_columns(table(text), choices);
  }
  template <class Action>
  void expect_refused(Action action, const std::string& place, const std::string& message) const
  {
    const std::string said = test::refusal(action),
                      start = (directory / "points.csv").string() + place + ": ";
    EXPECT_TRUE(said.starts_with(start)) << said;
    EXPECT_NE(said.find(message), std::string::npos) << said;
  }
};

TEST_F(Points, UnitsAreReadFromTheNames)
{
  const ReferencePoints p =
      read("\xef\xbb\xbf# a comment\r\n\r\n x_mm, y_cm ,z_m,shear_rad,arc_length_um,polar_angle_deg,note\r\n"
           "1,+2,3,0.5,7,8.5,\"a, \"\"b\"\"\"\r\n# another\r\n-1e1,0,0,0,0,0,\r\n");
  ASSERT_EQ(p.points.size(), 2U);
  EXPECT_EQ(p.header_line, 3);
  EXPECT_EQ(p.points[0].line, 4);
  EXPECT_EQ(p.points[0][PointRole::x], 1e-3);
  EXPECT_EQ(p.points[0][PointRole::y], 2e-2);
  EXPECT_EQ(p.points[0][PointRole::z], 3.0);
  EXPECT_DOUBLE_EQ(p.points[0][PointRole::shear], 0.5 * 180.0 / M_PI);
  EXPECT_EQ(p.points[0][PointRole::arc], 7e-6);
  EXPECT_EQ(p.points[0][PointRole::polar], 8.5);
  EXPECT_EQ(p.points[1].line, 6);
  EXPECT_EQ(p.points[1][PointRole::x], -1e-2);
  const ReferencePoints outline = read("x_mm,y_mm\n1,2\n");
  EXPECT_TRUE(outline.of(PointRole::x) && outline.of(PointRole::y));
  EXPECT_FALSE(outline.of(PointRole::shear));
}

TEST_F(Points, ColumnsCanBeChosen)
{
  const std::string text = "x_mm,y_mm,one_deg,two_deg\n1,2,3,4\n";
  EXPECT_EQ(read(text, {"shear=two_deg"}).points[0][PointRole::shear], 4.0);
  const ReferencePoints turned = read(text, {"x=y_mm", "y=x_mm", "shear=one_deg"});
  EXPECT_EQ(turned.points[0][PointRole::x], 2e-3);
  EXPECT_EQ(turned.points[0][PointRole::y], 1e-3);
}

TEST_F(Points, SaysWhatIsWrongWithAFile)
{
  struct Wrong {
    std::string text, place, message;
  };
  for (const Wrong& w : std::vector<Wrong>{
           {"", "", "holds no points"},
           {"x_mm,y_mm\n# nothing\n", "", "holds no points"},
           {"x_mm,,y_mm\n1,2,3\n", ":1:1", "column 2 has no name"},
           {"x_mm,x_mm\n1,2\n", ":1:1", "column `x_mm` twice"},
           {"x_mm,y_mm\n1,2\n1,2,3\n", ":3:1", "3 values for 2 columns"},
           {"x_mm,y_mm\n1,\"2\n", ":2:1", "a quotation mark is not closed"},
           {"x_mm,y_mm\n1,two\n", ":2:1", "y_mm: `two` is not a number"},
           {"x_mm,y_mm\n1,\n", ":2:1", "y_mm: `` is not a number"},
           {"x_mm,y_mm\n1,nan\n", ":2:1", "y_mm: `nan` is not a number"},
           {"x_mm,y_mm\n1,1e999\n", ":2:1", "y_mm: `1e999` is not a number"},
           {"x_mm,y_mm\n1,+-2\n", ":2:1", "y_mm: `+-2` is not a number"},
           {"x,y_mm\n1,2\n", ":1:1", "column `x` names no unit: call it x_mm, _cm, _m or _um"},
           {"x_mm,y_mm,shear\n1,2,3\n", ":1:1", "column `shear` names no unit: call it shear_deg or _rad"},
           {"x_deg,y_mm\n1,2\n", ":1:1", "column `x_deg`: x is a length, not an angle"},
           {"x_mm,y_mm,shear_mm\n1,2,3\n", ":1:1", "column `shear_mm`: shear is an angle, not a length"},
           {"x_mm,y_mm,shaer_deg\n1,2,3\n", ":1:1", "unknown column `shaer_deg`; did you mean `shear_deg`?"},
           {"x_mm,x_m,y_mm\n1,2,3\n", ":1:1",
            "columns `x_mm` and `x_m` both give x; choose with --column x=x_mm"},
           {std::string("x_mm,y_mm\n1,2\xff\n"), ":2:4", "is not UTF-8 text: not a file of points"},
       })
    expect_refused([&] { read(w.text); }, w.place, w.message);
  expect_refused([&] { read("x_mm,y_mm\n1,2\n", {"shear=shear_deg"}); }, ":1:1",
                 "there is no column `shear_deg` for shear; there are x_mm and y_mm");
  const std::string two = message_of<InputError>([&] { read("x_mm,y_mm\n1,a\nb,2\n"); });
  EXPECT_EQ(std::count(two.begin(), two.end(), '\n'), 1); // all at once
  EXPECT_EQ(
      test::refusal([&] { read_points(directory / "none.csv"); }).find((directory / "none.csv").string()),
      0U);
}

const std::string two_sets = "layup,x_mm,y_mm\n0/90,1,2\n0/90,3,4\n+-45,5,6\n+-45,7,8\n";

TEST_F(Points, RowsAreChosenByConditions)
{
  EXPECT_EQ(chosen(two_sets, {"layup=+-45"}).rows.size(), 2U);
  EXPECT_EQ(chosen(two_sets, {"layup!=+-45", "x_mm>1"}).rows.size(), 1U);
  EXPECT_EQ(chosen(two_sets, {"layup==0/90", "x_mm>=1.0"}).rows.size(), 2U);
  EXPECT_EQ(chosen("x_mm,y_mm\n1,2\n10,3\n9,4\n", {"x_mm<10"}).rows.size(), 2U); // as numbers
  EXPECT_EQ(chosen("x_mm,y_mm\n1,2\n10,3\n9,4\n", {"x_mm<=9", "y_mm=4.0"}).rows.size(), 1U);
}

TEST_F(Points, SetsAreNotMixedUnawares)
{
  expect_refused([&] { chosen(two_sets, {}); }, ":1:1",
                 "column `layup` tells 2 sets apart, 0/90 and +-45: choose with --where layup=0/90");
  EXPECT_EQ(chosen("name,x_mm,y_mm\na,1,2\nb,3,4\n", {}).rows.size(), 2U); // a name for each
  EXPECT_EQ(chosen("name,x_mm,y_mm\na,1,2\na,3,4\n", {}).rows.size(), 2U); // one set
  EXPECT_EQ(chosen("x_mm,y_mm\n1,2\n1,3\n2,x\n", {}).rows.size(), 3U);     // said later, at its place
}

TEST_F(Points, SaysWhatIsWrongWithACondition)
{
  expect_refused(
      [&] { chosen(two_sets, {"layout=0/90"}); }, ":1:1",
      "there is no column `layout` for --where; there are layup, x_mm and y_mm; did you mean `layup`?");
  expect_refused([&] { chosen(two_sets, {"layup=90"}); }, ":1:1",
                 "no row is left by --where layup=90; column `layup` holds 0/90 and +-45");
  expect_refused([&] { chosen(two_sets, {"layup<3"}); }, ":2:1",
                 "`0/90` is not a number, which --where layup<3");
  for (const std::string text : {"layup", "=3", "", "a~3", "a!3"})
    EXPECT_THROW(read_condition(text), std::invalid_argument) << text;
  for (const std::string text : {"shear", "shaer=a", "=a", "shear=", ""})
    EXPECT_THROW(read_column_choice(text), std::invalid_argument) << text;
}

TEST_F(Points, TheReferencesThatComeWithItAreGood)
{
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TOWFORM_SOURCE_DIR) / "cases/reference")) {
    if (entry.path().extension() != ".csv") continue;
    PointTable t = read_points(entry.path());
    if (t.column("layup") >= 0) keep_rows(t, {read_condition("layup=0/90")});
    EXPECT_GT(read_columns(t, {}).points.size(), 10U) << entry.path();
  }
}

} // namespace
} // namespace towform
