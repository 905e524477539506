#include "material/gf_pp.hpp"
#include "output/results_reader.hpp"
#include "solver/model.hpp"
#include "solver/press_case.hpp"
#include "towform/shear_law.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

/// A Maxwell element: N_dot = G theta_dot - N / tau.
struct Maxwell : ShearLaw {
  double spring = 5e3, relaxation = 1e-3; // G [N/m], tau [s]

  double update(ShearPoint& p, double angle, double dt) const override
  {
    const double force = (p.force + spring * (angle - p.angle)) / (1.0 + dt / relaxation);
    p = {angle, force, std::abs(angle - p.angle) / dt};
    return force * force / (spring * relaxation);
  }
  [[nodiscard]] double modulus() const override { return spring; }
  [[nodiscard]] std::string description() const override { return fmt::format("Maxwell, {} N/m", spring); }
};

MaterialParameters with(std::shared_ptr<const ShearLaw> law)
{
  Case c;
  c.material.constituents = test::gf_pp_twill();
  c.material.curve_rate_min = 1.0;
  c.material.curve_rate_max = 20.0;
  use_law(c, std::move(law));
  return c.material;
}

TEST(OwnLaw, AnswersForTheSheet)
{
  const auto law = std::make_shared<Maxwell>();
  const FabricMaterial material = make_fabric_material(with(law), 1e-3);
  ShearPoint p;
  const double lost = std::visit([&](const auto& l) { return l.update(p, 0.1, 1e-4); }, material.law);
  EXPECT_DOUBLE_EQ(p.force, 5e3 * 0.1 / 1.1);
  EXPECT_DOUBLE_EQ(lost, p.force * p.force / 5.0);
  // At a constant rate N -> G tau rate (1 - exp(-theta/(rate tau))); backward Euler in 100 steps is within 1
  // %.
  for (const double rate : {50.0, 500.0, 4000.0})
    EXPECT_NEAR(material.surface->force(0.8, rate), 5.0 * rate * (1.0 - std::exp(-0.8 / (rate * 1e-3))),
                0.05 * rate);
}

TEST(OwnLaw, ItsTangentIsThatOfItsUpdate)
{
  const Maxwell law;
  const ShearPoint before{0.3, 40.0, 5.0};
  ShearPoint after = before;
  law.update(after, 0.32, 1e-3);
  EXPECT_NEAR(law.tangent(before, after, 1e-3), 5e3 / 2.0, 1e-4);
}

TEST(OwnLaw, IsRefusedWhenItIsNoGood)
{
  MaterialParameters m = with(std::make_shared<Maxwell>());
  m.own_law = nullptr; // as a case file leaves it
  EXPECT_NE(message_of<std::domain_error>([&] { make_fabric_material(m, 1e-3); }).find("Maxwell, 5000 N/m"),
            std::string::npos);
  struct Broken : Maxwell {
    double update(ShearPoint& p, double angle, double dt) const override
    {
      const double lost = Maxwell::update(p, angle, dt);
      if (angle > 1.0) p.force = NAN;
      return lost;
    }
  };
  EXPECT_NE(message_of<std::domain_error>([&] {
              make_fabric_material(with(std::make_shared<Broken>()), 1e-3);
            }).find("no finite force at 57."),
            std::string::npos);
  auto soft = std::make_shared<Maxwell>();
  soft->spring = 0.0;
  EXPECT_THROW(make_fabric_material(with(soft), 1e-3), std::domain_error);
}

/// With a case that a user would form.
struct OwnLawRun : Press {
  [[nodiscard]] Case with_law(double spring = 5e3) const
  {
    Case c = read();
    auto law = std::make_shared<Maxwell>();
    law->spring = spring;
    use_law(c, law);
    return c;
  }
  [[nodiscard]] std::vector<Vec3> formed() const { return read_sheet(out / "results.h5", {}).position; }
};

TEST_F(OwnLawRun, StepsAreStableForItsModulus)
{
  EXPECT_NEAR(build_model(with_law()).shear_modulus, 5e3, 1e-9);
  EXPECT_LT(build_model(with_law(5e6)).first_step, build_model(with_law()).first_step);
}

TEST_F(OwnLawRun, IsReadBackFromTheResolvedCase)
{
  std::ofstream(directory / "again.toml") << resolved_case(with_law());
  const Case c = read_case(directory / "again.toml");
  EXPECT_EQ(c.material.law, LawKind::own);
  EXPECT_EQ(c.material.own_law_words, "Maxwell, 5000 N/m");
  EXPECT_EQ(resolved_case(c), resolved_case(with_law()));
}

TEST_F(OwnLawRun, GoesOnWithTheSameLawOnly)
{
  EXPECT_EQ(run(with_law(), {out, 1, true, true}).code, ExitCode::done);
  const std::vector<Vec3> whole = formed();
  RunOptions some{out, 1, true, true};
  some.controls.max_steps = 30;
  EXPECT_EQ(run(with_law(), some).code, ExitCode::interrupted);
  RunOptions rest{out, 1, true};
  EXPECT_THROW(resume(rest), InputError);
  const auto other = std::make_shared<Maxwell>();
  other->spring = 6e3;
  rest.law = other;
  EXPECT_NE(message_of<CheckpointError>([&] { resume(rest); }).find("the law Maxwell, 5000 N/m"),
            std::string::npos);
  rest.law = std::make_shared<Maxwell>();
  EXPECT_EQ(resume(rest).code, ExitCode::done);
  EXPECT_EQ(formed(), whole);
}

} // namespace
} // namespace towform
