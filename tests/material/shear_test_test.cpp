#include "case/case_files.hpp"
#include "material/shear_test.hpp"
#include <cmath>
#include <fmt/format.h>

namespace towform {
namespace {

constexpr double degree = M_PI / 180.0;

/// A sheet whose force is known: thinning, stiffening with the angle.
double sheet(double theta, double rate)
{
  return (20.0 + 15.0 * std::sin(theta) + 30.0 / std::pow(std::cos(theta), 2)) * std::pow(rate, 0.4);
}
/// The same without the rate.
double dry(double theta, double) { return sheet(theta, 1.0); }

ShearTest frame() { return {ShearTest::Kind::picture_frame, 0.115, 0.0, 0.0}; }
ShearTest strip(double ratio) { return {ShearTest::Kind::bias_extension, 0.0, 0.1 * ratio, 0.1}; }

/// The force of a strip from its energy: each region's own shear angle and rate.
TestRun run_of(const ShearTest& test, double speed, double (*force)(double, double), double to = 60.0)
{
  TestRun run;
  run.speed = speed;
  for (double deg = 0.5; deg <= to; deg += 0.75) {
    const double theta = deg * degree, rate = speed / test.lever(theta);
    run.angle.push_back(theta);
    run.force.push_back(test.force(theta, force(theta, rate), force(0.5 * theta, 0.5 * rate)));
  }
  return run;
}

double worst_error(const FittedTest& fitted, double (*force)(double, double), double from = 0.0)
{
  double worst = 0.0;
  for (const ShearCurve& c : fitted.curves.curves)
    for (double theta = from; theta <= c.max_angle(); theta += 0.5 * degree)
      worst = std::max(worst, std::abs(c.force(theta) / force(theta, c.rate()) - 1.0));
  return worst;
}

TEST(ShearTest, KinematicsAreTheirOwnInverse)
{
  for (const ShearTest& test : {frame(), strip(2.0), strip(3.0)})
    for (const double theta : {0.0, 0.3, 0.9, 1.3}) {
      EXPECT_NEAR(test.angle(test.displacement(theta)), theta, 1e-12);
      const double step = 1e-6;
      EXPECT_NEAR(test.lever(theta),
                  (test.displacement(theta + step) - test.displacement(theta - step)) / (2 * step), 1e-9);
    }
  // Eqs. 13-14 and F_s = F/(2 cos(pi/4 - theta/2)).
  const double theta = 0.8;
  EXPECT_NEAR(frame().lever(theta), 0.115 * std::sin(M_PI_4 - 0.4), 1e-15);
  EXPECT_NEAR(frame().force(theta, 70.0, 999.0), 2.0 * 70.0 * 0.115 * std::cos(M_PI_4 - 0.4), 1e-12);
  EXPECT_TRUE(std::isnan(frame().angle(0.2)));
}

TEST(ShearTest, RegionsOfTheStrip)
{
  // With L = 2 W: full shear over W^2/2, half over W^2, the rest of 2 W^2 (triangles of W/2 height) rigid.
  const auto w = strip(2.0).weights(0.0);
  EXPECT_NEAR(w.full, 0.5 * 0.01, 1e-15);
  EXPECT_NEAR(w.half, 0.5 * 0.01, 1e-15);
  EXPECT_NEAR(strip(3.0).weights(0.0).full, 1.5 * 0.01, 1e-15);
}

TEST(FitTest, RecoversAKnownSheetFromPictureFrames)
{
  EXPECT_LT(worst_error(fit_test(frame(), {run_of(frame(), 0.01, dry)}), dry), 0.002);
  const FittedTest two = fit_test(frame(), {run_of(frame(), 0.05, sheet), run_of(frame(), 0.005, sheet)});
  ASSERT_EQ(two.curves.curves.size(), 2U);
  EXPECT_LT(two.curves.curves[0].rate(), two.curves.curves[1].rate());
  EXPECT_LT(worst_error(two, sheet), 0.01);
}

TEST(FitTest, RecoversAKnownSheetFromBiasExtension)
{
  for (const double ratio : {2.0, 3.0}) {
    const ShearTest test = strip(ratio);
    EXPECT_LT(worst_error(fit_test(test, {run_of(test, 0.01, dry)}), dry), 0.01) << ratio;
    const FittedTest three = fit_test(
        test, {run_of(test, 0.002, sheet), run_of(test, 0.05, sheet, 55.0), run_of(test, 0.01, sheet)});
    ASSERT_EQ(three.curves.curves.size(), 3U);
    EXPECT_LT(worst_error(three, sheet), 0.01) << ratio;
    EXPECT_LE(three.curves.curves[0].max_angle(), 55.0 * degree);
  }
}

TEST(FitTest, SmoothsNoise)
{
  TestRun run = run_of(frame(), 0.01, dry);
  for (std::size_t i = 0; i < run.force.size(); ++i) // one per cent, as if at random
    run.force[i] *= 1.0 + 0.01 * std::sin(37.0 * static_cast<double>(i * i));
  const FittedTest fitted = fit_test(frame(), {run});
  EXPECT_LT(worst_error(fitted, dry, 2.0 * degree), 0.015);
  EXPECT_LE(fitted.orders.front(), 8);
}

TEST(FitTest, NeedsEnoughPoints)
{
  TestRun run = run_of(frame(), 0.01, dry);
  run.angle.resize(4);
  run.force.resize(4);
  EXPECT_THROW(fit_test(frame(), {run}), std::domain_error);
  run = run_of(frame(), 0.01, dry);
  for (double& force : run.force) force = -force;
  EXPECT_THROW(fit_test(frame(), {run}), std::domain_error);
  run = run_of(frame(), 0.01, dry);
  for (std::size_t i = 0; i < run.angle.size(); ++i) run.angle[i] = 0.3;
  EXPECT_THROW(fit_test(frame(), {run}), std::domain_error);
}

class TestFiles : public CaseFiles {
protected:
  std::string problem(const std::string& text, std::optional<double> speed = std::nullopt,
                      const ShearTest& test = frame()) const
  {
    try {
      read_test(write("test.csv", text), test, speed, std::nullopt);
    } catch (const InputError& e) {
      EXPECT_EQ(e.code(), ExitCode::files);
      return fmt::format("{}: {}", e.issues().front().where.line, e.issues().front().message);
    }
    return "accepted";
  }
};

TEST_F(TestFiles, GroupsRunsBySpeed)
{
  const auto runs = read_test(write("test.csv", "# a frame\n\nspeed_mm_per_s, displacement_mm,force_N\n"
                                                "5,1,10\n1,1,4\n5,2,12\n"),
                              frame(), std::nullopt, std::nullopt);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(*runs[0].speed, 1e-3);
  EXPECT_EQ(runs[1].force, (std::vector<double>{10.0, 12.0}));
  EXPECT_NEAR(runs[1].angle[1], frame().angle(2e-3), 1e-15);
  const auto normalised =
      read_test(write("n.csv", "angle_deg,shear_force_N_per_m,rate_rad_per_s\n30,70,0.1\n"), frame(),
                std::nullopt, std::nullopt);
  EXPECT_NEAR(normalised[0].force[0], frame().force(30.0 * degree, 70.0, 0.0), 1e-12);
  EXPECT_EQ(*normalised[0].rate, 0.1);
}

TEST_F(TestFiles, BadOnesAreRefusedWithTheirLine)
{
  EXPECT_EQ(problem("angle_deg,force_N\n1,2\n", 0.01), "accepted");
  EXPECT_EQ(problem("angle_deg,force_n\n1,2\n", 0.01),
            "1: unknown column `force_n`; did you mean `force_N`?");
  EXPECT_EQ(problem("angle_deg\n1\n", 0.01), "1: needs a column force_N or shear_force_N_per_m");
  EXPECT_EQ(problem("angle_deg,force_N\n1,2\n"),
            "1: has no column speed_mm_per_s or rate_rad_per_s; or give --speed or --rate");
  EXPECT_EQ(problem("angle_deg,force_N\n1,x\n", 0.01), "2: force_N: `x` is not a number");
  EXPECT_EQ(problem("angle_deg,force_N\n1,2,3\n", 0.01), "2: 3 values for 2 columns");
  EXPECT_EQ(problem("displacement_mm,force_N\n1,2\n90,3\n", 0.01),
            "3: displacement_mm 90 is outside a shear angle of 0 .. 85 deg");
  EXPECT_EQ(problem("angle_deg,force_N\n", 0.01), "0: has no measured point");
  EXPECT_EQ(problem("", 0.01), "0: has no measured point");
  EXPECT_EQ(problem("angle_deg,shear_force_N_per_m\n1,2\n", 0.01, strip(2.0)),
            "1: a bias-extension test needs force_N: its force becomes N only with that of half the angle");
}

} // namespace
} // namespace towform
