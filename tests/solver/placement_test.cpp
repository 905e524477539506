#include "press_case.hpp"
#include "solver/model.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

class Placement : public Press {
protected:
  [[nodiscard]] std::vector<InputIssue> issues_of(const std::vector<std::string>& overrides = {}) const
  {
    try {
      build_model(read(overrides));
    } catch (const InputError& error) {
      return error.issues();
    }
    return {};
  }
  /// The one issue there is, at the place of a tool's `mesh` key (lines of the case count from 1).
  void expect_one(const std::vector<InputIssue>& issues, int line, const std::string& message) const
  {
    ASSERT_EQ(issues.size(), 1U);
    EXPECT_EQ(issues[0].where.file, (directory / "press.toml").string());
    EXPECT_EQ(issues[0].where.line, line);
    EXPECT_EQ(issues[0].where.column, 8) << "where the value stands";
    EXPECT_EQ(issues[0].code, ExitCode::case_file);
    EXPECT_NE(issues[0].message.find(message), std::string::npos) << issues[0].message;
  }
  static constexpr int ball_mesh = 11, left_mesh = 15, right_mesh = 18;
};

TEST_F(Placement, ToolsThatTouchTheSheetAreAccepted) { EXPECT_TRUE(issues_of().empty()); }

TEST_F(Placement, ASheetThatStartsInsideAToolIsRefused)
{
  expect_one(issues_of({"tool.left.position=[0,0,'0.3 mm']"}), left_mesh,
             "the blank starts 0.3 mm inside tool 'left'");
}

TEST_F(Placement, AToolInTheWrongUnitIsRefused)
{
  SurfaceMesh in_mm = test::sphere(20.0, 8);
  for (Vec3& p : in_mm.points) p.z += 20.5;
  write_stl(directory / "ball.stl", in_mm, "ball, mm");
  expect_one(issues_of(), ball_mesh, "is mesh_unit = 1 right?");
  EXPECT_TRUE(issues_of({"tool.ball.mesh_unit=mm"}).empty());
}

TEST_F(Placement, AToolThatNeverComesNearIsRefused)
{
  expect_one(issues_of({"tool.right.position=['200 mm', 0, 0]"}), right_mesh,
             "tool 'right' never comes near the blank");
  // From there it would have to move, and a motion counts.
  EXPECT_TRUE(issues_of({"tool.right.position=['200 mm', 0, 0]", "tool.right.motion.axis=x",
                         "tool.right.motion.displacement=-195 mm"})
                  .empty());
}

TEST_F(Placement, ATiltedBlankIsLookedAtAsItLies)
{
  // Turned about y, one side of the 60 mm goes 30 mm sin(5 degrees) = 2.6 mm into its block, the other away.
  expect_one(issues_of({"blank.tilt=[0, '5 deg']", "tool.ball.position=[0,0,'1 mm']"}), right_mesh,
             "mm inside tool 'right'");
  EXPECT_TRUE(issues_of({"blank.tilt=[0, '5 deg']", "tool.ball.position=[0,0,'1 mm']",
                         "tool.right.position=[0,0,'-5 mm']"})
                  .empty());
}

TEST_F(Placement, ATiltedBlankStartsFreeOfForce)
{
  const Model model =
      build_model(read({"blank.tilt=['10 deg', '20 deg']", "tool.ball.position=[0,0,'20 mm']",
                        "tool.left.position=[0,0,'-20 mm']", "tool.right.position=[0,0,'-20 mm']"}));
  const System s = start(model);
  double highest = 0.0;
  for (std::size_t n = 0; n < s.sheet.position.size(); ++n) {
    EXPECT_LT(norm(s.sheet.force[n]), 1e-8);
    EXPECT_NEAR(norm(s.sheet.position[n]), norm(model.blank.mesh.points[n]), 1e-15);
    highest = std::max(highest, s.sheet.position[n].z);
  }
  const double a = M_PI / 18.0; // about x, then about y: z = y sin a cos 2a - x sin 2a
  EXPECT_NEAR(highest, 0.03 * (std::sin(a) * std::cos(2.0 * a) + std::sin(2.0 * a)), 1e-12);
}

TEST_F(Placement, EveryToolIsLookedAt)
{
  const auto issues = issues_of({"tool.left.position=[0,0,'0.3 mm']", "tool.right.position=[0,0,'1 m']"});
  ASSERT_EQ(issues.size(), 2U);
}

TEST_F(Placement, AnUnreadableMeshIsAnIssueOfItsKey)
{
  std::ofstream(directory / "left.stl") << "solid nothing\nendsolid\n";
  const auto issues = issues_of();
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues[0].where.line, left_mesh);
  EXPECT_EQ(issues[0].code, ExitCode::files);
  EXPECT_NE(issues[0].message.find("left.stl"), std::string::npos);
}

} // namespace
} // namespace towform
