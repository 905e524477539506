#include "report/plot.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace towform {

TEST(Plot, TicksAreRoundAndCoverTheRange)
{
  EXPECT_EQ(round_ticks(0.0, 60.0, 7), (std::vector<double>{0, 10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(round_ticks(-0.3, 0.9, 4), (std::vector<double>{0.0, 0.5}));
  for (const double scale : {1e-9, 1.0, 1e7}) {
    const std::vector<double> ticks = round_ticks(0.13 * scale, 0.87 * scale, 6);
    EXPECT_GE(ticks.size(), 3U);
    EXPECT_LE(ticks.size(), 6U);
  }
  EXPECT_EQ(round_ticks(2.0, 2.0, 5), std::vector<double>{2.0});
}

TEST(Plot, BreaksACurveAtWhatIsNoNumber)
{
  Plot plot{"A & B", "x", "y", {{"c", {{0, 0}, {1, 1}, {2, NAN}, {3, 1}, {4, 0}}, false}}, {}};
  const std::string page = plot_html(plot);
  EXPECT_NE(page.find("A &amp; B"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
  const std::size_t curve = page.find("class=\"curve series-0\"");
  ASSERT_NE(curve, std::string::npos);
  const std::string path = page.substr(curve, page.find("/>", curve) - curve);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
}

TEST(Plot, ManyPointsTakeLittleRoom)
{
  PlotSeries dense{"c", {}, false};
  for (int i = 0; i < 100000; ++i) dense.points.emplace_back(i * 1e-5, 0.3);
  EXPECT_LT(plot_html({"t", "x", "y", {dense}, {}}).size(), 20000U);
}

TEST(Plot, NothingIsShownOfNothing)
{
  EXPECT_TRUE((Plot{"t", "x", "y", {{"c", {}, false}}, {}}.empty()));
  EXPECT_TRUE(Plot{}.empty());
}

} // namespace towform
