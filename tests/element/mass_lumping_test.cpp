#include "element/mass_lumping.hpp"
#include "element/sheet.hpp"
#include "element/step_limit.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace towform {
namespace {

constexpr double share = 0.2;

Membrane membrane_of(const Blank& blank)
{
  Membrane membrane(blank, {1e6, 1.0}, test::law(LawKind::viscous), YarnStrain::strip);
  membrane.own_stiffness = 5e3;
  return membrane;
}

std::vector<double> masses(const Membrane& membrane, const std::vector<double>& factors)
{
  std::vector<double> mass;
  for (std::size_t n = 0; n < factors.size(); ++n) mass.push_back(1.48 * membrane.node_area[n] * factors[n]);
  return mass;
}

Blank blank_of(Pattern pattern, double degrees, Symmetry symmetry = Symmetry::none, int elements = 2000)
{
  BlankParameters p;
  p.size = {0.1, 0.08};
  p.elements = elements;
  p.pattern = pattern;
  p.fibre_angle = degrees * M_PI / 180.0;
  p.mesh_angle = -p.fibre_angle; // grid lines along the sides
  p.thickness = 1e-3;
  p.symmetry = symmetry;
  return make_blank(p);
}

TEST(MassLumping, KeepsTheSheetsMassAndThatOfItsParts)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured})
    for (const double degrees : {0.0, 30.0, 45.0}) {
      const Blank blank = blank_of(pattern, degrees, Symmetry::none, 5000);
      const Membrane membrane = membrane_of(blank);
      const std::vector<double> factors = lumping_factors(blank, membrane, share);
      EXPECT_GE(*std::min_element(factors.begin(), factors.end()), 1.0 - share);
      double whole = 0.0;
      Vec3 moment;
      for (std::size_t n = 0; n < factors.size(); ++n) {
        whole += membrane.node_area[n] * factors[n];
        moment += membrane.node_area[n] * factors[n] * blank.mesh.points[n];
      }
      EXPECT_NEAR(whole, 0.1 * 0.08, 1e-12);
      EXPECT_LT(norm(moment) / whole, 2e-4) << static_cast<int>(pattern) << ", " << degrees; // its centre [m]
      // A disc twenty elements wide, away from the edges, which take some hundredths from everywhere.
      double thirds = 0.0, here = 0.0;
      for (std::size_t n = 0; n < factors.size(); ++n)
        if (norm(blank.mesh.points[n] - Vec3{0.01, 0.005, 0.0}) < 0.019) {
          thirds += membrane.node_area[n];
          here += membrane.node_area[n] * factors[n];
        }
      EXPECT_NEAR(here / thirds, 1.0, 0.1) << static_cast<int>(pattern) << ", " << degrees;
    }
}

TEST(MassLumping, LeavesThirdsWithoutAShare)
{
  const Blank blank = blank_of(Pattern::unstructured, 30.0);
  for (const double factor : lumping_factors(blank, membrane_of(blank), 0.0)) EXPECT_EQ(factor, 1.0);
}

TEST(MassLumping, LetsTheStepBeLonger)
{
  const auto gain = [](const Blank& blank) {
    const Membrane membrane = membrane_of(blank);
    const auto limit = [&](double its_share) {
      const std::vector<double> mass = masses(membrane, lumping_factors(blank, membrane, its_share));
      return StepLimit(blank, membrane, mass, 1.0).at(blank.mesh.points);
    };
    return limit(share) / limit(0.0);
  };
  EXPECT_GT(gain(blank_of(Pattern::diagonal, 0.0)), 1.08);
  EXPECT_GT(gain(blank_of(Pattern::diagonal, 45.0)), 1.25);
  EXPECT_GT(gain(blank_of(Pattern::unstructured, 30.0)), 1.1);
}

TEST(MassLumping, APartHasTheFactorsOfTheWhole)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::cross})
    for (const double degrees : {0.0, 45.0})
      for (const Symmetry symmetry : {Symmetry::x, Symmetry::y, Symmetry::quarter}) {
        const Blank whole = blank_of(pattern, degrees), part = blank_of(pattern, degrees, symmetry);
        const std::vector<double> of_whole = lumping_factors(whole, membrane_of(whole), share),
                                  of_part = lumping_factors(part, membrane_of(part), share);
        for (std::size_t n = 0; n < of_part.size(); ++n) {
          const auto same = std::find_if(whole.mesh.points.begin(), whole.mesh.points.end(),
                                         [&](const Vec3& p) { return norm(p - part.mesh.points[n]) < 1e-9; });
          ASSERT_NE(same, whole.mesh.points.end()) << static_cast<int>(pattern) << ", " << degrees << ", symmetry "
                                                   << static_cast<int>(symmetry);
          EXPECT_NEAR(of_part[n], of_whole[static_cast<std::size_t>(same - whole.mesh.points.begin())], 1e-9)
              << static_cast<int>(pattern) << ", " << degrees << ", symmetry " << static_cast<int>(symmetry) << ", node at "
              << part.mesh.points[n].x << ", " << part.mesh.points[n].y;
        }
      }
}

TEST(MassLumping, IsTheSameAtAnySize)
{
  Blank blank = blank_of(Pattern::unstructured, 30.0);
  const std::vector<double> factors = lumping_factors(blank, membrane_of(blank), share);
  for (Vec3& p : blank.mesh.points) p *= 8.0;
  const std::vector<double> larger = lumping_factors(blank, membrane_of(blank), share);
  for (std::size_t n = 0; n < factors.size(); ++n) EXPECT_NEAR(larger[n], factors[n], 1e-9);
}

} // namespace
} // namespace towform
