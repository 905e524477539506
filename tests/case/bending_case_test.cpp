#include "case_files.hpp"

namespace towform {

namespace {

/// Line numbers matter to the tests.
const std::string strip = R"([blank]
size = ["100 mm", "100 mm"]
elements = 200
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[time]
end = "2 s"
)";

} // namespace

using BendingCase = CaseFiles;

TEST_F(BendingCase, IsOffWithoutAValue)
{
  const Case c = read(strip);
  EXPECT_FALSE(c.material.has_bending());
  EXPECT_EQ(c.load.gravity, Vec3{});
  EXPECT_EQ(resolved_case(c).find("bending"), std::string::npos); // its damping says nothing then
}

TEST_F(BendingCase, OneStiffnessOrOneForEachFamily)
{
  const Case one = read(strip, {"material.bending_stiffness=2 mN m"});
  EXPECT_EQ(*one.material.bending_stiffness, (Vec2{2e-3, 2e-3}));
  EXPECT_EQ(one.material.bending_damping, 0.05);
  const Case two = read(strip, {R"(material.bending_stiffness=["1 mN m", "3 N mm"])"});
  EXPECT_EQ(*two.material.bending_stiffness, (Vec2{1e-3, 3e-3}));
  EXPECT_EQ(read(resolved_case(two)).material.bending_stiffness, two.material.bending_stiffness);
  EXPECT_EQ(read(strip, {"material.bending_stiffness=1e-3"}).material.bending_stiffness->x, 1e-3);
}

TEST_F(BendingCase, Table)
{
  const Case c =
      read(strip, {R"(material.bending_table=[["10 1/m", "15 mN"], ["0.05 1/mm", "30 mN"], [200, 0.04]])"});
  ASSERT_EQ(c.material.bending_table.size(), 3U);
  EXPECT_EQ(c.material.bending_table[1].curvature, 50.0);
  EXPECT_EQ(c.material.bending_table[1].moment, 0.03);
  EXPECT_TRUE(c.material.has_bending());
  const Case again = read(resolved_case(c));
  EXPECT_EQ(again.material.bending_table[2].moment, 0.04);
}

TEST_F(BendingCase, Gravity)
{
  const Case c = read(strip, {R"(load.gravity=[0, 0, "-9.81 m/s2"])"});
  EXPECT_EQ(c.load.gravity, (Vec3{0.0, 0.0, -9.81}));
  EXPECT_EQ(read(resolved_case(c)).load.gravity, c.load.gravity);
}

TEST_F(BendingCase, SaysWhatIsWrong)
{
  const auto message = [&](const std::string& override) {
    const auto issues = issues_of(strip, {override});
    return issues.size() == 1 ? issues.front().message : std::to_string(issues.size()) + " issues";
  };
  EXPECT_EQ(message("material.bending_stiffness=1 mN"),
            "material.bending_stiffness: \"1 mN\" is a force, not a bending stiffness; use N m, mN m, N mm "
            "or mN mm");
  EXPECT_EQ(message("material.bending_stiffness=0 N m"), "material.bending_stiffness: \"0 N m\" must be > 0");
  EXPECT_EQ(message("material.bending_stiffness=[1, 2, 3]"),
            "material.bending_stiffness must be one or two bending stiffnesses, such as \"2 mN mm\" or "
            "[\"2 mN mm\", \"2 mN mm\"], not a list of 3");
  EXPECT_EQ(message("material.bending_table=[[10, 0.01], [5, 0.02]]"),
            "material.bending_table: 5 must be a greater curvature than the point before it");
  EXPECT_EQ(message("material.bending_table=[[10, 0.01], [20, 0.005]]"),
            "material.bending_table: 0.005 must not be a smaller moment than the point before it");
  EXPECT_EQ(message("material.bending_table=[10, 0.01]"), "2 issues");
  EXPECT_EQ(message("load.gravity=[0, 0, \"9.81 m/s\"]"),
            "load.gravity: \"9.81 m/s\" is a velocity, not an acceleration; use m/s^2, m/s2 or mm/s^2");
  const auto both =
      issues_of(strip, {"material.bending_stiffness=1e-3", "material.bending_table=[[10, 0.01]]"});
  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(both.front().message, "material has both bending_stiffness and bending_table; give one");
}

TEST_F(BendingCase, GravityStaysInTheMirrorPlanesAndWithTheExplicitSolver)
{
  const auto issues = issues_of(strip, {"blank.symmetry=x", "load.gravity=[1, 0, 0]"});
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues.front().message, "load.gravity pulls the sheet off a mirror plane of blank.symmetry");
  EXPECT_TRUE(issues_of(strip, {"blank.symmetry=x", "load.gravity=[0, 1, -9.81]"}).empty());
  const auto of_statics =
      issues_of(strip, {"solver=implicit", "blank.element=quadrilateral", "load.gravity=[0, 0, -9.81]"});
  ASSERT_EQ(of_statics.size(), 1U);
  EXPECT_EQ(of_statics.front().message, "the implicit solver knows no gravity: take the explicit one");
}

} // namespace towform
