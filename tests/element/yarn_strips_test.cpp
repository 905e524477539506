#include "element/membrane.hpp"
#include "element/sheet.hpp"
#include "element/yarn_strips.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace towform {
namespace {

using test::degree;

const FabricLaw& any_law()
{
  static const FabricLaw law = test::law(LawKind::elastic);
  return law;
}

std::vector<double> areas(const Blank& blank) { return Membrane(blank, YarnLaw{1e6, 0.1}, any_law()).areas(); }

TEST(YarnStrips, HoldEveryYarnOfEveryElementOnce)
{
  for (const Pattern pattern : {Pattern::diagonal, Pattern::cross, Pattern::unstructured}) {
    const Blank blank = test::blank(pattern, 20.0 * degree, 0.0, 400);
    const std::vector<double> area = areas(blank);
    const YarnStrips strips = lay_strips(blank, area);
    std::vector<int> met(2 * area.size(), 0);
    for (std::size_t i = 0; i < strips.size(); ++i)
      for (const YarnEntry entry : strips.entries_of(i)) {
        ++met[entry];
        EXPECT_EQ(strips.of[entry], static_cast<int>(i));
      }
    EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(met.size()));
    EXPECT_NEAR(std::accumulate(strips.area.begin(), strips.area.end(), 0.0),
                2.0 * std::accumulate(area.begin(), area.end(), 0.0), 1e-14);
  }
}

TEST(YarnStrips, AreLongAlongTheYarnAndNarrowAcross)
{
  const Blank blank = test::blank(Pattern::unstructured, 30.0 * degree, 0.0, 2000);
  const std::vector<double> area = areas(blank);
  const YarnStrips strips = lay_strips(blank, area);
  const double edge = std::sqrt(2.0 * 0.1 * 0.08 / static_cast<double>(area.size()));
  const auto middle = [&](int e) {
    const auto& [a, b, c] = blank.mesh.triangles[e];
    return (1.0 / 3.0) * (blank.mesh.points[a] + blank.mesh.points[b] + blank.mesh.points[c]);
  };
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const auto entries = strips.entries_of(i);
    const bool warp = entries.front() % 2 == 0;
    const Vec3 along = warp ? blank.warp : blank.weft, across = warp ? blank.weft : blank.warp;
    for (const YarnEntry entry : entries) {
      EXPECT_EQ(entry % 2 == 0, warp);
      const Vec3 apart = middle(entry / 2) - middle(entries.front() / 2);
      EXPECT_LT(std::abs(dot(apart, across)), 1.01 * YarnStrips::strip_width * edge);
      EXPECT_LT(std::abs(dot(apart, along)),
                2.0 * YarnStrips::strip_length * edge); // of two that were joined
    }
  }
  // About five or six triangles in each: a third of the constraints that the nodes could take.
  const double mean = 2.0 * static_cast<double>(area.size()) / static_cast<double>(strips.size());
  EXPECT_GT(mean, 4.5);
  EXPECT_LT(mean, 7.0);
}

TEST(YarnStrips, AreLongerWhereTheMeshFollowsTheYarns)
{
  const auto triangles = [](double mesh_angle) {
    const Blank blank = test::blank(Pattern::diagonal, 0.0, mesh_angle, 4000);
    return 2.0 * static_cast<double>(blank.mesh.triangles.size()) / static_cast<double>(lay_strips(blank, areas(blank)).size());
  };
  EXPECT_NEAR(triangles(0.0) / triangles(10.0 * degree), YarnStrips::aligned_length / YarnStrips::strip_length, 0.15);
}

TEST(YarnStrips, AreNotNeededWhereTheMeshFollowsTheYarns)
{
  EXPECT_TRUE(follows_yarns(test::blank(Pattern::diagonal, 0.0, 0.0, 200)));
  EXPECT_FALSE(follows_yarns(test::blank(Pattern::cross, 0.0, 0.0, 200)));
  EXPECT_FALSE(follows_yarns(test::blank(Pattern::diagonal, 0.0, 10.0 * degree, 200)));
  EXPECT_FALSE(follows_yarns(test::blank(Pattern::unstructured, 0.0, 0.0, 200)));
}

/// Yarn energy of a sheet whose warps slide along themselves by a function of their place across: an
/// inextensible net does this without any.
double energy_of_sliding(const Blank& blank, YarnStrain kind, double kink)
{
  const Membrane membrane(blank, YarnLaw{1e6, 1.0}, any_law(), kind);
  std::vector<Vec3> x = blank.mesh.points;
  for (Vec3& p : x) p += 1e-4 * std::max(0.0, (dot(p, blank.weft) - kink) / 0.01) * blank.warp;
  return membrane.yarn_energy(test::loaded(membrane, x));
}

TEST(YarnStrips, LetYarnsSlidePastEachOtherOnAnyMesh)
{
  // A kink along the warp, which triangles that cross it see as stretched yarns.
  struct Sheet {
    Pattern pattern;
    double mesh_angle;
  };
  for (const auto& [pattern, mesh_angle] :
       {Sheet{Pattern::diagonal, 45.0}, Sheet{Pattern::diagonal, 15.0}, Sheet{Pattern::unstructured, 0.0}}) {
    const Blank blank = test::blank(pattern, 45.0 * degree, mesh_angle * degree, 2000);
    double strips = 0.0, triangles = 0.0;
    for (const double kink : {-0.011, -0.004, 0.0021, 0.0073}) {
      strips += energy_of_sliding(blank, YarnStrain::strip, kink);
      triangles += energy_of_sliding(blank, YarnStrain::triangle, kink);
    }
    EXPECT_LT(strips, 0.08 * triangles) << "mesh angle " << mesh_angle;
  }
}

} // namespace
} // namespace towform
