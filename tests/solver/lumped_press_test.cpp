#include "solver/model.hpp"
#include "solver/press_case.hpp"
#include <gtest/gtest.h>
#include <numeric>

namespace towform {
namespace {

class LumpedPress : public Press {
protected:
  [[nodiscard]] Model model(std::vector<std::string> overrides) const
  {
    overrides.emplace_back("blank.pattern=unstructured");
    return build_model(read(overrides));
  }
};

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

TEST_F(LumpedPress, TakesLongerStepsWithTheSameMassAndAsStiffAContact)
{
  const Model thirds = model({"time.lumping=0"}), lumped = model({"time.lumping=0.2"});
  EXPECT_GT(lumped.first_step, 1.05 * thirds.first_step);
  EXPECT_NEAR(sum(lumped.mass), sum(thirds.mass), 1e-12 * sum(thirds.mass));
  EXPECT_NEAR(lumped.added_mass_fraction, 0.0, 1e-12);
  for (std::size_t i = 0; i < thirds.contacts.size(); ++i) {
    const double wanted = thirds.contacts[i].stiffness_per_area;
    EXPECT_NEAR(lumped.contacts[i].stiffness_per_area, wanted, 0.02 * wanted); // yarn damping follows the longer step
  }
}

TEST_F(LumpedPress, IsSteppedAsFinelyAsTheCaseWants)
{
  const double whole = model({"time.safety=1"}).first_step;
  for (const double safety : {0.5, 0.01, 0.001})
    EXPECT_NEAR(model({"time.safety=" + std::to_string(safety)}).first_step, safety * whole, 0.1 * safety * whole);
}

TEST_F(LumpedPress, LeavesMassesInThirdsUnderGravity)
{
  const Model heavy = model({"load.gravity=[0, 0, -9.81]", "time.lumping=0.2"});
  const double per_area = heavy.mass[0] / heavy.membrane.node_area[0];
  for (std::size_t n = 0; n < heavy.mass.size(); ++n)
    EXPECT_NEAR(heavy.mass[n] / heavy.membrane.node_area[n], per_area, 1e-9 * per_area);
}

TEST_F(LumpedPress, DampsYarnsAsMuchWhetherTheSheetResistsBendingOrNot)
{
  // Too little bending to limit the step, with which the masses are placed twice.
  const double without = model({"time.lumping=0.2"}).membrane.damping_time;
  EXPECT_NEAR(model({"time.lumping=0.2", "material.bending_stiffness=1 mN m"}).membrane.damping_time, without, 1e-3 * without);
}

TEST_F(LumpedPress, IsNotSlowerWhereBendingLimitsTheStep)
{
  for (const char* stiffness : {"0.1 N m", "3 N m", "10 N m", "30 N m", "1000 N m"}) {
    const std::string bending = std::string("material.bending_stiffness=") + stiffness;
    EXPECT_GT(model({bending, "time.lumping=0.2"}).first_step, 0.995 * model({bending}).first_step) << stiffness;
  }
}

} // namespace
} // namespace towform
