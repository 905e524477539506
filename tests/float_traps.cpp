#include "case/float_traps.hpp"
#include <gtest/gtest.h>
#include <limits>

namespace towform {
namespace {

// Every test of a debug build runs with traps.
class Traps : public testing::Environment {
public:
  void SetUp() override { trap_floats(); }
};
const testing::Environment* const traps = testing::AddGlobalTestEnvironment(new Traps);

double divided_by(double x)
{
  const volatile double at_run_time = x;
  return 1.0 / at_run_time;
}

TEST(FloatTraps, ANumberFromOutsideMayBeJudged)
{
  const UntrappedFloats judging;
  EXPECT_GT(divided_by(0.0), std::numeric_limits<double>::max());
}

#if TOWFORM_FLOAT_TRAPS
TEST(FloatTrapsDeathTest, DivisionByZeroEndsTheProgram)
{
  {
    const UntrappedFloats judging;
  }
  EXPECT_DEATH(divided_by(0.0), ""); // also after judging
}
#endif

} // namespace
} // namespace towform
