#include "element/bent.hpp"
#include "solver/bare_sheet.hpp"
#include "solver/field_tail.hpp"
#include "solver/frame_fields.hpp"
#include "solver/measure.hpp"
#include "solver/press_case.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace towform {
namespace {

TEST(FieldTail, HasThePercentileOfTheSortedValuesWhateverTheirOrder)
{
  std::mt19937 random(11);
  std::exponential_distribution<double> skewed(1.0);
  for (const std::size_t count : {1, 2, 15, 99, 100, 101, 1000, 20000}) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(skewed(random));
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double wanted = sorted[(count * 99) / 100];
    EXPECT_EQ(field_tail(values).percentile_99, wanted) << count;
    EXPECT_EQ(field_tail(sorted).percentile_99, wanted) << count;
    std::reverse(sorted.begin(), sorted.end());
    EXPECT_EQ(field_tail(sorted).percentile_99, wanted) << count;
  }
}

TEST(FieldTail, HasThatOfValuesThatRepeatOrThatASampleMisses)
{
  EXPECT_EQ(field_tail(std::vector<double>(5000, 3.0)).percentile_99, 3.0);
  std::vector<double> few(5000, 0.0); // the highest are all where the sample looks, and nowhere else
  for (std::size_t i = 0; i < 5000; i += 16) few[i] = 1.0 + double(i);
  std::vector<double> sorted = few;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(field_tail(few).percentile_99, sorted[4950]);
  for (std::size_t i = 0; i < 5000; ++i) few[i] = i % 16 == 0 && i < 640 ? 1.0 : 0.0; // fewer than one in a hundred
  EXPECT_EQ(field_tail(few).percentile_99, 0.0);
}

TEST(FieldTail, HasTheFirstOfTheLargestAndCountsThoseOverALimit)
{
  std::vector<double> values(10000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i % 100);
  for (const std::size_t place : {std::size_t{5001}, std::size_t{9000}}) values[place] = 500.0;
  const FieldTail tail = field_tail(values, 89.5);
  EXPECT_EQ(tail.largest, 500.0);
  EXPECT_EQ(tail.place, 5001U);
  EXPECT_DOUBLE_EQ(tail.fraction_over, 0.1002);
}

TEST(FieldExtremes, CountCompressionApartFromTension)
{
  Case c = test::bare_sheet();
  c.material.yarn_strain = YarnStrain::triangle; // a strip is a triangle's warp or weft
  const Model model = build_model(c);
  System s = start(model);
  const std::size_t elements = model.membrane.triangles.size();
  ASSERT_EQ(elements, 160U);
  const auto strain = [&](std::size_t e, double warp, double weft) {
    s.sheet.strip_strain[model.membrane.strips.of[2 * e]] = warp;
    s.sheet.strip_strain[model.membrane.strips.of[2 * e + 1]] = weft;
  };
  for (std::size_t e = 0; e < elements; ++e) strain(e, 0.03, 0.0);
  strain(7, 0.01, -0.02);
  strain(8, -0.006, -0.001);
  strain(9, -0.004, 0.0);
  const FieldExtremes x = field_extremes(model.membrane, s);
  EXPECT_DOUBLE_EQ(x.compression_max, 0.02);
  EXPECT_DOUBLE_EQ(x.compression_over_half_percent, 2.0 / 160.0);
  EXPECT_DOUBLE_EQ(x.compression_p99, 0.006); // one of 160 is above
  EXPECT_DOUBLE_EQ(x.strain_max, 0.03);
}

TEST(Frames, HoldTheCurvatureOfASheetThatDoesNotResistIt)
{
  Case c = test::bare_sheet();
  c.blank.elements = 1000;
  const Model model = build_model(c);
  System s = start(model);
  s.sheet.position = test::rolled(model.blank, 0.05, 0.0); // about y: along the warp
  const CurvatureOperator curvature(model.blank, model.clamped, 0);
  const Frame frame = frame_field(model, s, curvature, "curvature");
  EXPECT_TRUE(frame_field(model, s, curvature, "clearance").clearance.empty()); // there are no tools
  ASSERT_EQ(frame.curvature.size(), model.membrane.triangles.size());
  for (const auto& k : frame.curvature) {
    EXPECT_NEAR(k[0], 20.0, 0.2); // 1/R, to (h/R)^2 = 0.01
    EXPECT_NEAR(k[1], 0.0, 0.01);
  }
}

TEST_F(Press, SaysWhenCompressionHidesWrinkles)
{
  // Two grips push a flat strip together by 1/60: nothing makes it buckle, and all of it is shortened.
  std::ofstream(directory / "pushed.toml") << R"(
[blank]
size = ["60 mm", "20 mm"]
edge = "5 mm"
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[boundary]]
name = "foot"
edge = "left"
[[boundary]]
name = "head"
edge = "right"
motion = { axis = "x", displacement = "-1 mm" }
[time]
end = "10 ms"
)";
  const auto said = [&](const std::vector<std::string>& overrides) {
    const RunOutcome outcome = run(read_case(directory / "pushed.toml", overrides), {out, 1, true, true});
    EXPECT_EQ(outcome.code, ExitCode::done) << outcome.summary.message;
    std::ifstream log(out / "run.log");
    const std::string lines((std::istreambuf_iterator<char>(log)), {});
    return std::pair(outcome.summary, lines.find("compression hides wrinkles") != std::string::npos);
  };
  const auto [pushed, warned] = said({});
  EXPECT_TRUE(warned);
  EXPECT_GT(pushed.fibre_compression_over_half_percent, 0.99);
  EXPECT_NEAR(pushed.fibre_compression_p99, 1.0 / 60.0, 0.1 / 60.0);
  const auto [pulled, warned_again] = said({"boundary.head.motion.displacement=1 mm"});
  EXPECT_FALSE(warned_again);
  EXPECT_LT(pulled.fibre_compression_max, 0.005);
  EXPECT_NEAR(pulled.fibre_strain_p99, 1.0 / 60.0, 0.1 / 60.0);
}

class Clearances : public Press {};

TEST_F(Clearances, AreDistancesFromTheNearestTool)
{
  const Model model = build_model(read());
  System s = start(model);
  s.tools[0].displacement = 1e-3; // the ball's motion is along z: it has risen by 1 mm
  const Frame frame = frame_field(model, s, CurvatureOperator(model.blank, model.clamped, 0), "clearance");
  ASSERT_EQ(frame.clearance.size(), model.mass.size());
  for (std::size_t n = 0; n < model.mass.size(); ++n) {
    const Vec3& x = model.blank.mesh.points[n];
    const double ball = norm(x - Vec3{0.0, 0.0, 0.0215}) - 0.02;
    const double block = std::hypot(std::max(0.02 - std::abs(x.x), 0.0), 0.5e-3);
    const double exact = std::min(ball, block) - 0.5e-3;
    EXPECT_NEAR(frame.clearance[n], exact, exact < block - 0.5e-3 ? 5e-4 : 1e-9); // the ball has facets
  }
}

TEST_F(Clearances, AreNegativeInsideATool)
{
  const Model model = build_model(read());
  System s = start(model);
  for (Vec3& x : s.sheet.position) x.z -= 2e-3;
  const Frame frame = frame_field(model, s, CurvatureOperator(model.blank, model.clamped, 0), "clearance");
  for (std::size_t n = 0; n < model.mass.size(); ++n)
    if (std::abs(model.blank.mesh.points[n].x) > 0.025) {
      EXPECT_NEAR(frame.clearance[n], -2e-3, 1e-9);
    }
}

} // namespace
} // namespace towform
