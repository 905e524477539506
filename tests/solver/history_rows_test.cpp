#include "solver/press_case.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace towform {
namespace {

class HistoryRows : public Press {
protected:
  struct Row {
    double time, step, dt;
  };
  /// Of a press with so many rows between three frames.
  std::vector<Row> rows(int count)
  {
    EXPECT_EQ(form({"output.history=" + std::to_string(count), "output.frames=3"}).code, ExitCode::done);
    std::ifstream file(out / "history.csv");
    std::string line;
    std::getline(file, line); // names
    std::vector<Row> found;
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      Row row{};
      char comma = 0;
      cells >> row.time >> comma >> row.step >> comma >> row.dt;
      found.push_back(row);
    }
    return found;
  }
  static constexpr double end = 5e-3;
};

TEST_F(HistoryRows, LieAtTheStepNearestToTheirTimeAndFramesExactlyAtTheirs)
{
  const std::vector<Row> found = rows(10);
  ASSERT_EQ(found.size(), 13U); // with the start, and the two of three frames that fall between
  const double times[] = {0.0, 0.1, 0.2, 0.3, 1.0 / 3.0, 0.4, 0.5, 0.6, 2.0 / 3.0, 0.7, 0.8, 0.9, 1.0};
  int between = 0;
  for (std::size_t i = 1; i < found.size(); ++i) {
    const double wanted = times[i] * end, off = std::abs(found[i].time - wanted);
    const bool frame = i == 4 || i == 8 || i == 12;
    EXPECT_LE(off, frame ? 1e-9 * end : 0.501 * found[i].dt) << i;
    between += off > 1e-9 * end ? 1 : 0;
    EXPECT_GT(found[i].step, found[i - 1].step);
  }
  EXPECT_GT(between, 4); // they cost no steps of their own
}

TEST_F(HistoryRows, HaveAStepAtTheirTimeWhereThereAreFewSteps)
{
  const std::vector<Row> found = rows(200);
  ASSERT_EQ(found.size(), 203U);
  for (int i = 0; i <= 60; ++i) EXPECT_NEAR(found[static_cast<std::size_t>(i)].time, i * end / 200, 1e-8 * end); // before the frame
}

} // namespace
} // namespace towform
