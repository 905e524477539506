#include "case/case_files.hpp"
#include "material/curve_file.hpp"
#include "material/fabric_law.hpp"
#include "material/gf_pp.hpp"
#include "material/prediction.hpp"
#include "material/rate_line.hpp"
#include "material/shear_resistance.hpp"
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace towform {
namespace {

constexpr double degree = M_PI / 180.0;

class CurveFiles : public CaseFiles {
protected:
  /// What is wrong with a curve file: "line: message" of the first issue.
  std::string problem(const std::string& text) const
  {
    try {
      read_curves(write("curves.txt", text));
    } catch (const InputError& e) {
      EXPECT_EQ(e.code(), ExitCode::files);
      return fmt::format("{}: {}", e.issues().front().where.line, e.issues().front().message);
    }
    return "accepted";
  }

  static std::string curve(double rate, double constant, const std::string& more = "")
  {
    std::string text = fmt::format("{} 0 {}", rate, constant);
    for (int k = 1; k <= ShearCurve::order; ++k) text += " 0";
    return text + more + "\n";
  }
};

MaterialParameters twill()
{
  MaterialParameters m;
  m.constituents = test::gf_pp_twill();
  m.temperature = 463.15;
  m.curve_rate_min = 1.0;
  m.curve_rate_max = 20.0;
  m.elastic_rate = 10.0;
  m.fibre_modulus = 1e9;
  m.relaxation_ratio = 0.1;
  return m;
}

TEST_F(CurveFiles, ReadBackToTheSameCurvesAndAsTheyAreDescribed)
{
  const FabricMaterial made = make_fabric_material(twill(), 1e-3);
  write("x", "");
  write_curves(at("curves.txt"), {*made.curves, 463.15, 1e-3, {"from a test"}});
  const CurveFile read = read_curves(at("curves.txt"));
  ASSERT_EQ(read.curves.curves.size(), 20U);
  EXPECT_NEAR(*read.temperature, 463.15, 1e-9);
  EXPECT_NEAR(*read.thickness, 1e-3, 1e-15);
  for (std::size_t i = 0; i < 20; ++i)
    for (double theta = 0.0; theta < 1.4; theta += 0.05) {
      const double force = made.curves->curves[i].force(theta);
      EXPECT_NEAR(read.curves.curves[i].force(theta), force, 1e-9 * force);
    }
  // As a person would evaluate the fifth curve at 40 degrees from the text.
  std::ifstream stream(at("curves.txt"));
  std::string line;
  while (std::getline(stream, line) && !line.starts_with("5 ")) {
  }
  std::istringstream words(line);
  double rate = 0.0, error = 0.0, a = 0.0, sum = 0.0;
  words >> rate >> error;
  const double x = 2.0 * 40.0 / 75.0 - 1.0;
  for (int k = 0; words >> a; ++k) sum += a * std::pow(x, k);
  EXPECT_NEAR(sum, made.curves->curves[4].force(40.0 * degree), 1e-9 * sum);
  EXPECT_NEAR(error, made.curves->curves[4].fit_error(), 0.01 * error);
}

TEST_F(CurveFiles, AreAsMonotoneAndPositiveAsTheModel)
{
  MaterialParameters m = twill();
  for (const TowKinematics kinematics : {TowKinematics::measured, TowKinematics::minimum_power}) {
    m.constituents.tow_kinematics = kinematics;
    const ShearResistance model(m.constituents, 1e-3, m.temperature);
    const auto force = [&](double theta, double rate) { return model.force(theta, rate); };
    const ShearCurves curves = fit_curves(force, 1.0, 20.0, 4, curve_max_angle);
    for (const ShearCurve& c : curves.curves) {
      EXPECT_LT(c.fit_error(), 0.01);
      for (double deg = 0.0; deg < 75.0; deg += 0.5) {
        EXPECT_GT(c.force(deg * degree), 0.0);
        // Where the model rises or falls by more than the fit can be wrong, the curve goes the same way.
        const double step = 2.0 * degree, from = model.force(deg * degree, c.rate());
        const double rise = deg < 73.0 ? model.force(deg * degree + step, c.rate()) - from : 0.0;
        if (std::abs(rise) > 2.0 * c.fit_error() * (from + std::abs(rise))) {
          EXPECT_GT((c.force(deg * degree + step) - c.force(deg * degree)) * rise, 0.0) << deg;
        }
      }
    }
  }
}

TEST_F(CurveFiles, BadOnesAreRefusedWithTheirLine)
{
  const std::string head = "# curves\nmax_angle 75 deg\n";
  EXPECT_EQ(problem(head + curve(1, 50) + curve(2, 60)), "accepted");
  EXPECT_EQ(problem(head), "0: has no curve");
  EXPECT_EQ(problem(curve(1, 50)), "0: has no line `max_angle`, the angle up to which the curves hold");
  EXPECT_EQ(problem(head + "hello\n"),
            "3: `hello` is neither a curve's rate nor max_angle, temperature or thickness");
  EXPECT_EQ(problem(head + curve(1, 50, " 7")),
            "3: a curve has 14 numbers (rate, fit error, a_0 ... a_11), not 15");
  EXPECT_EQ(problem(head + curve(1, 50) + "2 0 x\n"), "4: `x` is not a number");
  EXPECT_EQ(problem(head + curve(2, 50) + curve(2, 60)),
            "4: a curve's rate, 2 rad/s, must be above that of the curve before it, 2");
  EXPECT_EQ(problem(head + curve(0, 50)), "3: a curve's rate must be positive");
  EXPECT_EQ(problem(head + curve(1, -50)), "3: the curve's force is nowhere positive");
  EXPECT_EQ(problem("max_angle 95 deg\n" + curve(1, 50)), "1: `95 deg` must be within 0.06 deg .. 85 deg");
  EXPECT_EQ(problem("max_angle 75\n" + curve(1, 50)).substr(0, 20), "1: `75` has no unit;");
  EXPECT_EQ(problem(head + "1 0 0 10 0 0 0 0 0 0 0 0 0 0\n"),
            "3: the curve's force is negative, -10 N/m at 0.0 deg");
  EXPECT_THROW(read_curves(at("none.txt")), InputError);
}

TEST_F(CurveFiles, TakeThePlaceOfTheModel)
{
  MaterialParameters m = twill();
  m.law = LawKind::viscous;
  const FabricMaterial made = make_fabric_material(m, 1e-3);
  write("x", "");
  write_curves(at("curves.txt"), {*made.curves, 463.15, 1e-3, {}});
  m.curves = at("curves.txt");
  m.constituents = {}; // not needed any more
  const FabricMaterial read = make_fabric_material(m, 1e-3);
  EXPECT_EQ(read.curves->curves.size(), 20U);
  for (const double theta : {0.05, 0.5, 1.2}) {
    // Between the curves the surfaces agree within the fit and the steps in rate; below they are Newtonian.
    for (const double rate : {1.0, 1.7, 6.5, 13.3, 20.0})
      EXPECT_NEAR(read.surface->force(theta, rate) / made.surface->force(theta, rate), 1.0, 0.01);
    EXPECT_NEAR(read.surface->force(theta, 0.2), 0.2 * read.surface->force(theta, 1.0),
                2e-3 * read.surface->force(theta, 0.2));
    EXPECT_GT(read.surface->force(theta, 200.0), read.surface->force(theta, 20.0));
  }
  m.law = LawKind::elastic; // follows the curve of its rate
  const FabricMaterial elastic = make_fabric_material(m, 1e-3);
  EXPECT_NEAR(std::get<ElasticLaw>(elastic.law).curves->curves.front().force(0.5),
              made.surface->force(0.5, 10.0), 0.01 * made.surface->force(0.5, 10.0));
  m.temperature = 473.15;
  EXPECT_THROW(make_fabric_material(m, 1e-3), InputError);
  m.temperature = 463.15;
  EXPECT_THROW(make_fabric_material(m, 2e-3), InputError);
}

TEST_F(CurveFiles, OneCurveServesTheElasticLawOnly)
{
  MaterialParameters m = twill();
  m.curves = write("curves.txt", "max_angle 75 deg\n" + curve(3, 50));
  m.law = LawKind::elastic;
  ShearPoint p;
  std::get<ElasticLaw>(make_fabric_material(m, 1e-3).law).update(p, 0.4, 1e-5);
  EXPECT_NEAR(p.force, 50.0, 1e-10);
  m.law = LawKind::viscous;
  EXPECT_THROW(make_fabric_material(m, 1e-3), InputError);
}

TEST(RateLine, RisesWithTheRateAndEverLess)
{
  // A curve too low, one that would rise faster than the rate, and noise.
  const std::vector<double> rates{1.0, 2.0, 4.0, 8.0, 16.0}, forces{10.0, 9.0, 40.0, 41.0, 60.0};
  const RateLine line(rates, forces, 1e-3, RateLine::Below::newtonian);
  double last = 0.0, last_slope = 1e9;
  for (double r = 0.1; r < 100.0; r *= 1.01) {
    const double slope = (line.force(1.0001 * r) - line.force(r)) / (1e-4 * r);
    EXPECT_GT(line.force(r), last);
    EXPECT_LE(slope, last_slope * 1.0001);
    last = line.force(r);
    last_slope = slope;
  }
  for (std::size_t i = 0; i < rates.size(); ++i) EXPECT_GE(line.force(rates[i]), forces[i] * (1.0 - 1e-12));
  EXPECT_NEAR(line.force(4.0), 40.0, 1e-10);
  EXPECT_NEAR(line.force(0.5), 0.5 * line.force(1.0), 1e-12);
}

TEST_F(CurveFiles, PlainWeaveIsItsTangentIntegrated)
{
  Case c = read_material(write("case.toml", "[blank]\nthickness = \"1.2 mm\"\n[material]\n"
                                            "card = \"gf_pp_plain_weave\"\ntemperature = \"20 degC\"\n"));
  EXPECT_EQ(c.material.law, LawKind::elastic);
  EXPECT_EQ(c.material.fibre_modulus, 35.4e9);
  const FabricMaterial made = make_fabric_material(c.material, c.blank.thickness);
  for (const double g : {0.02, 0.3, 0.8, 1.2}) {
    ShearPoint p;
    std::get<ElasticLaw>(made.law).update(p, g, 1e-5);
    const double exact = 1.2e3 * (8.48 / 5 * std::pow(g, 5) - 12.0972 / 4 * std::pow(g, 4) +
                                  6.1275 / 3 * std::pow(g, 3) - 0.83 / 2 * g * g + 0.051 * g);
    EXPECT_NEAR(p.force, exact, 1e-3 * exact) << g;
  }
  c.material.law = LawKind::viscous;
  EXPECT_THROW(make_fabric_material(c.material, 1.2e-3), std::domain_error);
  c.material.law = LawKind::elastic;
  c.material.shear_tangent = {-1e6, 2e6}; // negative up to 0.5 rad
  const FabricMaterial clamped = make_fabric_material(c.material, 1e-3);
  EXPECT_NEAR(clamped.surface->force(0.4, 1.0), 0.0, 1e-9);
  EXPECT_NEAR(clamped.surface->force(0.9, 1.0), 1e-3 * 1e6 * 0.16, 0.3);
  EXPECT_THROW(predicted_curves(c), InputError);
}

} // namespace
} // namespace towform
