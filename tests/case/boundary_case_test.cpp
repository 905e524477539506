#include "case_files.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

/// Line numbers matter to the tests.
const std::string specimen_case = R"([blank]
size = ["100 mm", "100 mm"]
elements = 200
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[time]
end = "2 s"
[[boundary]]
name = "foot"
edge = "bottom"
[[boundary]]
name = "head"
edge = "top"
motion = { axis = "y", displacement = "20 mm", profile = "smooth" }
)";

const std::string frame = R"([[boundary]]
name = "frame"
kind = "picture_frame"
motion = { velocity = "1 mm/s" }
)";

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

/// The specimen in a frame instead of grips.
std::string framed_case() { return specimen_case.substr(0, specimen_case.find("[[boundary]]")) + frame; }

} // namespace

using BoundaryCase = CaseFiles;

TEST_F(BoundaryCase, Grips)
{
  const Case c = read(specimen_case);
  EXPECT_EQ(c.solver, SolverKind::explicit_dynamics);
  EXPECT_EQ(c.blank.element, ElementShape::triangle);
  EXPECT_TRUE(c.tools.empty());
  ASSERT_EQ(c.boundaries.size(), 2U);
  EXPECT_EQ(c.boundaries[0].name, "foot");
  EXPECT_EQ(c.boundaries[0].kind, BoundaryParameters::Kind::grip);
  EXPECT_EQ(c.boundaries[0].edge, BoundaryParameters::Edge::bottom);
  EXPECT_FALSE(c.boundaries[0].motion);
  EXPECT_EQ(c.boundaries[1].edge, BoundaryParameters::Edge::top);
  ASSERT_TRUE(c.boundaries[1].motion);
  EXPECT_EQ(c.boundaries[1].motion->axis, Axis::y);
  EXPECT_EQ(c.boundaries[1].motion->amount, 0.02);
  EXPECT_EQ(c.boundaries[1].motion->duration, 2.0);
  EXPECT_EQ(c.where("boundary[1].edge").line, 15);
}

TEST_F(BoundaryCase, PictureFrameOnQuadrilaterals)
{
  const Case c = read("solver = \"implicit\"\n" + replaced(framed_case(), "elements = 200",
                                                           "elements = 100\nelement = \"quadrilateral\""));
  EXPECT_EQ(c.solver, SolverKind::implicit);
  EXPECT_EQ(c.blank.element, ElementShape::quadrilateral);
  ASSERT_EQ(c.boundaries.size(), 1U);
  EXPECT_EQ(c.boundaries[0].kind, BoundaryParameters::Kind::picture_frame);
  EXPECT_EQ(c.boundaries[0].motion->quantity, Motion::Quantity::velocity);
}

TEST_F(BoundaryCase, OverridesGoByName)
{
  const Case c = read(specimen_case, {"boundary.head.motion.displacement=-3 mm", "boundary.foot.edge=top",
                                      "boundary.head.edge=bottom"});
  EXPECT_EQ(c.boundaries[1].motion->amount, -0.003);
  EXPECT_EQ(c.boundaries[0].edge, BoundaryParameters::Edge::top);
  const auto issues = issues_of(specimen_case, {"boundary.haed.edge=top"});
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_NE(issues[0].message.find("there is no boundary `haed`; did you mean `head`?"), std::string::npos)
      << issues[0].message;
}

TEST_F(BoundaryCase, ResolvedCaseReadsBackToItself)
{
  for (const std::string& text : {specimen_case, framed_case(), "solver = \"implicit\"\n" + framed_case()}) {
    const std::string resolved = resolved_case(read(text));
    const Case again = read_case(write("elsewhere/case.toml", resolved));
    EXPECT_EQ(resolved_case(again), resolved);
    EXPECT_NE(resolved.find("[[boundary]]"), std::string::npos);
  }
}

TEST_F(BoundaryCase, WhatIsWrongIsNamedWithItsPlace)
{
  struct Wrong {
    std::string what, with, place, message;
  };
  const std::string kept = "symmetry = \"quarter\"";
  const std::vector<Wrong> of_grips{
      {"edge = \"top\"", "", "13:1", "boundary.head.edge is missing (left, right, bottom or top"},
      {"edge = \"top\"", "edge = \"upper\"", "15:8", "must be \"left\", \"right\", \"bottom\" or \"top\""},
      {"edge = \"top\"", "edge = \"bottom\"", "15:8", "boundary.head holds the same edge as boundary.foot"},
      {"edge = \"top\"", "edge = \"left\"", "15:8", "boundary.head shares a corner with boundary.foot"},
      {"name = \"head\"", "name = \"foot\"", "14:8", "a second tool or boundary named \"foot\""},
      {"name = \"head\"", "", "13:1", "boundary.name is missing"},
      {"axis = \"y\", ", "", "16:10", "boundary.head.motion.axis is missing"},
      {"displacement = \"20 mm\", ", "", "16:10", "boundary.head.motion needs displacement or velocity"},
      {"edge = \"top\"", "edge = \"top\"\nfriction = 1", "16:1", "unknown key `friction` in [[boundary]]"},
      {"elements = 200", "elements = 200\n" + kept, "13:8", "boundary.foot.edge is not in the part"},
      {"elements = 200", "elements = 200\nelement = \"quadrilateral\"", "4:11",
       "needs solver = \"implicit\""},
  };
  for (const Wrong& wrong : of_grips) {
    const auto issues = issues_of(replaced(specimen_case, wrong.what, wrong.with));
    ASSERT_EQ(issues.size(), 1U) << wrong.with;
    EXPECT_TRUE(issues[0].text().starts_with("case.toml:" + wrong.place)) << issues[0].text();
    EXPECT_NE(issues[0].message.find(wrong.message), std::string::npos) << issues[0].text();
  }
  const std::string pulled_off =
      replaced(replaced(replaced(specimen_case, "elements = 200", "elements = 200\nsymmetry = \"x\""),
                        "axis = \"y\"", "axis = \"x\""),
               "edge = \"bottom\"", "edge = \"bottom\" ");
  ASSERT_EQ(issues_of(pulled_off).size(), 1U);
  EXPECT_NE(issues_of(pulled_off)[0].message.find("off the mirror plane"), std::string::npos);

  const std::vector<Wrong> of_frames{
      {"kind =", "edge = \"top\"\nkind =", "12:8", "boundary.frame.edge has no effect"},
      {"velocity =", "axis = \"x\", velocity =", "13:19", "boundary.frame.motion.axis has no effect"},
      {"\"100 mm\"]", "\"101 mm\"]", "2:8", "boundary.frame: a picture frame needs a square blank"},
      {"elements = 200", "elements = 200\nsymmetry = \"x\"", "4:12", "needs the whole blank"},
      {"[time]", "[[boundary]]\nname = \"a\"\nedge = \"top\"\n[time]", "13:1", "holds all four edges"},
  };
  for (const Wrong& wrong : of_frames) {
    const auto issues = issues_of(replaced(framed_case(), wrong.what, wrong.with));
    ASSERT_EQ(issues.size(), 1U) << wrong.with;
    EXPECT_TRUE(issues[0].text().starts_with("case.toml:" + wrong.place)) << issues[0].text();
    EXPECT_NE(issues[0].message.find(wrong.message), std::string::npos) << issues[0].text();
  }
}

} // namespace towform
