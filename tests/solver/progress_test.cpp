#include "solver/progress.hpp"
#include <gtest/gtest.h>

namespace towform {

namespace {
const ProgressState half{0.03, 0.06, 5000, 6e-6, 123, 0.0012, 21.25};
}

TEST(Progress, BarSaysWhereTheRunIs)
{
  EXPECT_EQ(
      bar_text(half, 42.0, 200, false),
      "[############............]   50.0 %  42 s to go  t 30.00 ms  step 5000  shear 21.2 deg  energy error "
      "0.12 %  dt 6 us (element 123)");
  EXPECT_NE(bar_text(half, 7200.0, 200, false).find("2.0 h to go"), std::string::npos);
}

TEST(Progress, BarFitsTheTerminal)
{
  for (int columns = 30; columns < 160; ++columns)
    EXPECT_LE(bar_text(half, 42.0, columns, false).size(), static_cast<std::size_t>(columns)) << columns;
}

TEST(Progress, ColourIsInTheBarAlone)
{
  const std::string plain = bar_text(half, 42.0, 80, false), coloured = bar_text(half, 42.0, 80, true);
  EXPECT_EQ(plain.find('\x1b'), std::string::npos);
  EXPECT_EQ(coloured.size(), plain.size() + 9); // two escape sequences, not counted as width
}

} // namespace towform
