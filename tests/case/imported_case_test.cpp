#include "case_files.hpp"

namespace towform {

namespace {

/// Line numbers matter to the tests.
const std::string disc_case = R"([blank]
mesh = "meshes/disc.msh"
mesh_unit = "mm"
fibre_1 = [1, 1, 0]
fibre_2 = [-2, 0.5, 0]
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[tool]]
name = "punch"
mesh = "meshes/punch.stl"
[time]
end = "2 s"
)";

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

} // namespace

class ImportedCase : public CaseFiles {
protected:
  void SetUp() override
  {
    CaseFiles::SetUp();
    write("meshes/disc.msh", "");
  }
};

TEST_F(ImportedCase, NamesAMeshAndTheYarns)
{
  const Case c = read(disc_case);
  EXPECT_EQ(c.blank.mesh, at("meshes/disc.msh"));
  EXPECT_EQ(c.blank.mesh_unit, 1e-3);
  ASSERT_TRUE(c.blank.fibre_1 && c.blank.fibre_2);
  EXPECT_EQ(*c.blank.fibre_1, (Vec3{1, 1, 0}));
  EXPECT_EQ(*c.blank.fibre_2, (Vec3{-2, 0.5, 0}));
}

TEST_F(ImportedCase, YarnsMayBeGivenToARectangleToo)
{
  const Case c = read(sample_with(5, "fibre_1 = [1, 0, 0]\nfibre_2 = [1, 2, 0]"));
  EXPECT_EQ(*c.blank.fibre_2, (Vec3{1, 2, 0}));
}

TEST_F(ImportedCase, ResolvedCaseReadsBackToItself)
{
  for (const std::string& text : {disc_case, sample_with(5, "fibre_1 = [1, 0, 0]\nfibre_2 = [1, 2, 0]")}) {
    const std::string resolved = resolved_case(read(text));
    const Case again = read_case(write("elsewhere/case.toml", resolved));
    EXPECT_EQ(resolved_case(again), resolved);
    EXPECT_EQ(resolved.find("fibre_angle"), std::string::npos);
  }
}

TEST_F(ImportedCase, WhatContradictsItIsNamedWithItsPlace)
{
  struct Wrong {
    std::string what, with, place, message;
  };
  const std::string thickness = "thickness = \"1 mm\"";
  std::vector<Wrong> all{
      {"disc.msh", "dish.msh", "2:8", "blank.mesh: \"meshes/dish.msh\" is not there; looked in "},
      {"fibre_2 = [-2, 0.5, 0]\n", "", "4:11", "blank.fibre_1 needs blank.fibre_2"},
      {"fibre_1 = [1, 1, 0]\n", "", "4:11", "blank.fibre_2 needs blank.fibre_1"},
      {"fibre_1 = [1, 1, 0]", "fibre_1 = [0, 0, 0]", "4:11", "blank.fibre_1 has no direction"},
      {"fibre_1 = [1, 1, 0]", "fibre_1 = [1, 1]", "4:11",
       "blank.fibre_1 must be three numbers, such as [1, 0, 0]"},
      {"fibre_1 = [1, 1, 0]", "fibre_1 = [1, nan, 0]", "4:15", "is not a finite number"},
      {"fibre_2 = [-2, 0.5, 0]", "fibre_2 = [-2, 0, 0.1]", "5:11", "blank.fibre_2 points out of the plane"},
      {"fibre_2 = [-2, 0.5, 0]", "fibre_2 = [-2, -2.1, 0]", "5:11",
       "parallel to fibre_1, or nearly: 1.4 degrees"},
      {thickness, thickness + "\nfibre_angle = 0", "7:15",
       "blank has both fibre_angle and directions of its fibres"},
      {"mesh_unit = \"mm\"", "mesh_unit = \"kg\"", "3:13", "blank.mesh_unit"},
      {"[blank]\n", "solver = \"implicit\"\n[blank]\n", "3:8",
       "the implicit solver meshes a rectangle itself"},
      {"[time]", "[[boundary]]\nname = \"a\"\nkind = \"picture_frame\"\n[time]", "2:8",
       "needs a square blank"},
  };
  for (const std::string key : {"size = [1, 1]", "elements = 100", "edge = \"5 mm\"", "mesh_angle = 0",
                                "pattern = \"cross\"", "element = \"triangle\""})
    all.push_back({thickness, thickness + "\n" + key, "7:" + std::to_string(key.find('=') + 3),
                   "blank has both mesh and " + key.substr(0, key.find(' '))});
  for (const Wrong& wrong : all) {
    const auto issues = issues_of(replaced(disc_case, wrong.what, wrong.with));
    ASSERT_EQ(issues.size(), 1U) << wrong.with;
    EXPECT_TRUE(issues[0].text().starts_with("case.toml:" + wrong.place + ": ")) << issues[0].text();
    EXPECT_NE(issues[0].message.find(wrong.message), std::string::npos) << issues[0].text();
  }
  const auto unit = issues_of(sample_with(4, "elements = 100\nmesh_unit = \"mm\""));
  ASSERT_EQ(unit.size(), 1U);
  EXPECT_NE(unit[0].message.find("blank.mesh_unit has no effect without mesh"), std::string::npos);
  const auto missing = issues_of(sample_with(4, "mesh = \"none.msh\""));
  ASSERT_EQ(missing.size(), 3U); // size and mesh_angle contradict it, and it is not there
  EXPECT_EQ(missing.back().code == ExitCode::files || missing.front().code == ExitCode::files ||
                missing[1].code == ExitCode::files,
            true);
}

} // namespace towform
