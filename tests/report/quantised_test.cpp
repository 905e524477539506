#include "report/quantised.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace towform {

TEST(Quantised, KeepsValuesToHalfAStep)
{
  const std::vector<double> first{-1.0, 100.0, 0.25, 200.0}, second{3.0, 150.0, 0.5, 100.0}; // two components
  ComponentRanges ranges(2);
  ranges.add(first);
  ranges.add(second);
  Quantised q = ranges.scale();
  add_frame(q, first);
  add_frame(q, second);
  EXPECT_DOUBLE_EQ(q.step[0], 4.0 / 65534.0);
  EXPECT_DOUBLE_EQ(q.step[1], 100.0 / 65534.0);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(q.value(i), first[i], 0.5001 * q.step[i % 2]);
    EXPECT_NEAR(q.value(4 + i), second[i], 0.5001 * q.step[i % 2]);
  }
}

TEST(Quantised, HasANumberForWhatIsNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ComponentRanges ranges(1);
  const std::vector<double> values{2.0, nan, 4.0};
  ranges.add(values);
  Quantised q = ranges.scale();
  add_frame(q, values);
  EXPECT_EQ(q.q, (std::vector<std::uint16_t>{0, Quantised::missing, 65534}));
}

TEST(Quantised, AConstantNeedsNoSteps)
{
  ComponentRanges ranges(1);
  ranges.add(std::vector<double>{463.15, 463.15});
  Quantised q = ranges.scale();
  add_frame(q, std::vector<double>{463.15, 463.15});
  EXPECT_EQ(q.step[0], 0.0);
  EXPECT_EQ(q.value(1), 463.15);
}

/// RFC 4648's own examples.
TEST(Base64, PadsAsTheStandardSays)
{
  const auto encoded = [](std::string text) {
    return base64({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

} // namespace towform
