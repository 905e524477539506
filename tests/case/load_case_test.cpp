#include "case_files.hpp"
#include <cmath>
#include <fmt/format.h>

namespace towform {
namespace {

class LoadCase : public CaseFiles {
protected:
  [[nodiscard]] std::string message(const std::vector<std::string>& overrides) const
  {
    const auto issues = issues_of(sample_case, overrides);
    return issues.size() == 1 ? issues[0].message : fmt::format("{} issues", issues.size());
  }
  static void expect_says(const std::string& message, const std::string& part)
  {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
};

TEST_F(LoadCase, APressureIsOneValueOrATable)
{
  EXPECT_TRUE(read(sample_case).load.pressure.empty());
  const Case constant = read(sample_case, {"load.pressure=0.1 MPa"});
  ASSERT_EQ(constant.load.pressure.size(), 1U);
  EXPECT_DOUBLE_EQ(constant.load.pressure[0].pressure, 1e5);
  const Case table = read(sample_case, {"load.pressure=[[0, 0], ['5 ms', '20 kPa']]"});
  ASSERT_EQ(table.load.pressure.size(), 2U);
  EXPECT_DOUBLE_EQ(table.load.pressure[1].time, 5e-3);
  EXPECT_DOUBLE_EQ(table.load.pressure[1].pressure, 2e4);
  for (const Case& c : {constant, table}) { // and back again
    const Case again = read_case(write("resolved.toml", resolved_case(c)));
    ASSERT_EQ(again.load.pressure.size(), c.load.pressure.size());
    EXPECT_EQ(again.load.pressure.back().pressure, c.load.pressure.back().pressure);
  }
}

TEST_F(LoadCase, ABadPressureIsNamed)
{
  expect_says(message({"load.pressure=5 mm"}), "is a length, not a pressure");
  expect_says(message({"load.pressure=[[0, 0], [0, '1 kPa']]"}), "must be later than the point before it");
  expect_says(message({"load.pressure=[[0, 0]]"}), "two or more points");
  expect_says(message({"load.pressure=[[0, 0], [1]]"}), "a point [time, pressure]");
}

TEST_F(LoadCase, ATiltedBlankKeepsToItsMirrorPlanes)
{
  EXPECT_DOUBLE_EQ(read(sample_case, {"blank.tilt=['10 deg', 0]", "blank.symmetry=x"}).blank.tilt.x,
                   M_PI / 18.0);
  expect_says(message({"blank.tilt=['10 deg', 0]", "blank.symmetry=y"}), "off a mirror plane");
  expect_says(message({"blank.tilt=[0, '10 deg']", "blank.symmetry=quarter"}), "off a mirror plane");
  expect_says(message({"blank.tilt=10 deg"}), "must be two angles, such as [\"2 deg\", \"2 deg\"]");
}

TEST_F(LoadCase, DashpotsOfContactLeaveAStableStep)
{
  EXPECT_EQ(read(sample_case, {"contact.damping=0.6"}).contact.damping, 0.6);
  expect_says(message({"contact.damping=0.5", "contact.penalty=0.5"}),
              "contact.damping = 0.5 leaves no stable step with contact.penalty = 0.5; at most 0.46");
}

} // namespace
} // namespace towform
