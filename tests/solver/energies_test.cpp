#include "solver/energy.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

TEST(Energies, ErrorIsWhatTheAccountFailsToExplainOverTheExternalWork)
{
  Energies e;
  EXPECT_EQ(e.error(), 0.0); // nothing has moved
  e.external = 10.0;
  e.kinetic = 1.0;
  e.yarn = 2.0;
  e.shear_elastic = 0.5;
  e.shear_dissipated = 4.0;
  e.contact = 0.25;
  e.friction = 0.75;
  e.bending = 0.3;
  e.bending_damping = 0.2;
  e.damping = 1.0;
  EXPECT_DOUBLE_EQ(e.internal(), 9.0);
  EXPECT_DOUBLE_EQ(e.error(), 0.0);
  e.shear_dissipated = 3.5; // half a joule of the ten has gone
  EXPECT_DOUBLE_EQ(e.error(), 0.05);
  e.shear_dissipated = 4.5; // or come from nowhere: then over what there is
  EXPECT_DOUBLE_EQ(e.error(), 0.5 / 10.5);
}

TEST(Energies, ErrorCannotHideBehindWorkGivenBack)
{
  Energies e;
  e.external = -1.0; // the sheet has pushed the tools, out of nothing
  EXPECT_DOUBLE_EQ(e.error(), 1.0);
  e.external = 1e-9; // almost all was given back, but much has been lost or made
  e.kinetic = 3.0;
  EXPECT_NEAR(e.error(), 1.0, 1e-8);
}

TEST(Energies, AreListedInTheOrderOfTheHistory)
{
  const Energies e{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  const auto list = listed(e);
  ASSERT_EQ(list.size(), 10U);
  for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i].second, static_cast<double>(i + 1));
  EXPECT_EQ(list.front().first, "kinetic");
  EXPECT_EQ(list.back().first, "external");
}

} // namespace
} // namespace towform
