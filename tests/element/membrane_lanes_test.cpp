#include "case/float_traps.hpp"
#include "element/arcsine.hpp"
#include "element/membrane_lanes.hpp"
#include "element/sheet.hpp"
#include "material/gf_pp.hpp"
#include "material/shear_resistance.hpp"
#include <gtest/gtest.h>
#include <memory>
#include <random>

namespace towform {
namespace {

TEST(Arcsine, IsExactToTheLastBits)
{
  for (int i = -100000; i <= 100000; ++i) {
    const double x = i / 100000.0, exact = std::asin(x);
    EXPECT_NEAR(arcsine(x), exact, 5e-16 * std::abs(exact)) << x;
  }
  for (int i = -50000; i <= 50000; ++i) EXPECT_EQ(arcsine_to_half(i / 100000.0), arcsine(i / 100000.0)) << i;
  EXPECT_EQ(arcsine(1.0), M_PI / 2.0);
  EXPECT_EQ(arcsine(0.0), 0.0);
  const UntrappedFloats untrapped;
  EXPECT_TRUE(std::isnan(arcsine(std::nan(""))));
}

/// Stretches from far below 1 to far above: some of a batch, and whole batches, that are near 1 and that are not.
TEST(MembraneBatch, MeasuresSmallAndLargeStretchesOfYarnsToTheLastBits)
{
  const int count = 61;
  MembraneBatch b{};
  const auto lanes = std::make_unique<BlockLanes>();
  const std::vector<double> one(count, 1.0), none(count, 0.0), area(count, 0.25);
  for (const double range : {1e-9, 1e-3, 7.7e-3, 7.9e-3, 0.05, 0.2, 0.9}) {
    for (int i = 0; i < count; ++i) {
      const double along = 1.0 + range * (i - 30) / 30.0, across = 1.0 - 0.5 * range * (i - 30) / 30.0;
      b.d1x[i] = 0.6 * along;
      b.d1y[i] = 0.8 * along;
      b.d1z[i] = 0.0;
      b.d2x[i] = 0.0;
      b.d2y[i] = -0.28 * across;
      b.d2z[i] = 0.96 * across;
    }
    yarn_vectors({one.data(), none.data(), none.data(), one.data(), area.data()}, b, 3, count, *lanes);
    for (int i = 0; i < count; ++i) {
      const double along = 1.0 + range * (i - 30) / 30.0, across = 1.0 - 0.5 * range * (i - 30) / 30.0;
      const int warp = 3 + i, weft = BlockLanes::size + 3 + i;
      EXPECT_NEAR(lanes->weighed_strain[warp], 0.25 * (along - 1.0), 2e-16) << range;
      EXPECT_NEAR(lanes->weighed_strain[weft], 0.25 * (across - 1.0), 2e-16) << range;
      EXPECT_NEAR(lanes->over_stretch[warp] * along, 1.0, 5e-16);
      EXPECT_NEAR(lanes->over_stretch[weft] * across, 1.0, 5e-16);
      EXPECT_NEAR(lanes->f1x[warp], 0.6, 4e-16);
      EXPECT_NEAR(lanes->f1y[warp], 0.8, 5e-16);
      EXPECT_NEAR(lanes->f2y[warp], -0.28, 3e-16);
      EXPECT_NEAR(lanes->f2z[warp], 0.96, 6e-16);
    }
  }
}

/// Loading, unloading, rest and reversal at rates over many decades, side by side and point by point.
TEST(MembraneBatch, AdvancesTheViscousLawToTheSameBits)
{
  const ShearResistance model(test::gf_pp_twill(), 1e-3, 463.15);
  const ViscousLaw law{
      std::make_shared<const ShearTable>([&](double theta, double rate) { return model.force(theta, rate); },
                                         ShearResistance::max_angle),
      1e5};
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> exponent(-4.0, 3.0), sign(-1.0, 1.0);
  constexpr double dt = 4e-6;
  const int count = 29; // not a whole number of vectors
  MembraneBatch b{};
  std::vector<ShearPoint> points(count);
  std::vector<double> sine(count), angle(count), force(count), rates(count), area(count, 1.0);
  const ShearLanes state{sine.data(), angle.data(), force.data(), rates.data()};
  for (int step = 0; step < 400; ++step) {
    for (int i = 0; i < count; ++i) {
      const double rate = sign(generator) * std::pow(10.0, exponent(generator));
      b.angle[i] = std::clamp(points[i].angle + rate * dt, -1.4, 1.4);
    }
    update(law, state, b, count, dt);
    for (int i = 0; i < count; ++i) {
      const double lost = law.update(points[i], b.angle[i], dt);
      ASSERT_EQ(b.force[i], points[i].force) << step << " " << i;
      ASSERT_EQ(b.rate[i], points[i].rate);
      ASSERT_EQ(b.lost[i], lost);
    }
    keep(area.data(), dt, count, b, state);
  }
}

TEST(MembraneBatch, FollowsTheElasticLawToTheSameBits)
{
  const auto law = std::get<ElasticLaw>(test::law(LawKind::elastic));
  MembraneBatch b{};
  const int count = 61;
  std::vector<double> old(count);
  for (int i = 0; i < count; ++i) b.angle[i] = -1.5 + 0.05 * i; // past the curve's end on either side, and through 0
  b.angle[30] = 1e-3;
  update(law, {old.data(), old.data(), old.data(), old.data()}, b, count, 1e-6);
  for (int i = 0; i < count; ++i) {
    ShearPoint p;
    EXPECT_EQ(b.lost[i], law.update(p, b.angle[i], 1e-6));
    EXPECT_EQ(b.force[i], p.force) << b.angle[i];
    EXPECT_EQ(b.rate[i], p.rate);
  }
}

} // namespace
} // namespace towform
