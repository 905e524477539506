#include "element/membrane.hpp"
#include "element/sheet.hpp"
#include "element/strip_lattice.hpp"
#include "element/yarn_strips.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <utility>

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

/// The line of a triangle's edge along a yarn, and on which side of it the triangle is.
struct LineAndSide {
  double line;
  bool beyond;
};
LineAndSide line_of(const Blank& blank, int element, bool warp)
{
  const Vec3 across = cross(Vec3{0.0, 0.0, 1.0}, warp ? blank.warp : blank.weft);
  std::array<double, 3> y{};
  for (std::size_t k = 0; k < 3; ++k) y[k] = dot(blank.mesh.points[blank.mesh.triangles[element][k]], across);
  std::sort(y.begin(), y.end());
  const bool beyond = y[1] - y[0] < y[2] - y[1];
  return {beyond ? y[0] : y[2], beyond};
}

TEST(YarnStrips, AreBarsOfNineElementsOrMoreWhereTheMeshFollowsTheYarns)
{
  for (const int elements : {4000, 5000, 7000}) { // of which a lattice would cut short ones somewhere
    const Blank blank = test::blank(Pattern::diagonal, 0.0, 0.0, elements);
    const YarnStrips strips = lay_strips(blank, areas(blank));
    std::size_t shortest = 2 * blank.mesh.triangles.size(), longest = 0;
    for (std::size_t i = 0; i < strips.size(); ++i) {
      const auto entries = strips.entries_of(i);
      shortest = std::min(shortest, entries.size());
      longest = std::max(longest, entries.size());
      const bool warp = entries.front() % 2 == 0;
      const auto [line, beyond] = line_of(blank, entries.front() / 2, warp);
      for (const YarnEntry entry : entries) {
        const auto its = line_of(blank, entry / 2, warp);
        EXPECT_NEAR(its.line, line, 1e-12);
        EXPECT_EQ(its.beyond, beyond);
      }
    }
    EXPECT_GE(shortest, static_cast<std::size_t>(YarnStrips::aligned_elements)) << elements;
    EXPECT_LT(longest, static_cast<std::size_t>(4 * YarnStrips::aligned_elements)) << elements; // twice two on the middle line
  }
}

TEST(YarnStrips, OfAQuarterAreThoseOfTheWhole)
{
  for (const int elements : {3000, 5000}) { // the middle of the blank lies between lines of yarn and on one
    BlankParameters p;
    p.size = {0.1, 0.08};
    p.elements = elements;
    p.pattern = Pattern::diagonal;
    p.thickness = 1e-3;
    const Blank whole = make_blank(p);
    p.symmetry = Symmetry::quarter;
    const Blank quarter = make_blank(p);
    const auto place = [](const Blank& blank, std::size_t e) {
      const auto& [a, b, c] = blank.mesh.triangles[e];
      const Vec3 sum = blank.mesh.points[a] + blank.mesh.points[b] + blank.mesh.points[c];
      return std::pair(std::lround(1e7 * sum.x), std::lround(1e7 * sum.y));
    };
    std::map<std::pair<long, long>, std::size_t> in_whole;
    for (std::size_t e = 0; e < whole.mesh.triangles.size(); ++e) in_whole[place(whole, e)] = e;
    const YarnStrips of_whole = lay_strips(whole, areas(whole)), of_quarter = lay_strips(quarter, areas(quarter));
    std::map<int, int> one_way, other_way;
    for (std::size_t e = 0; e < quarter.mesh.triangles.size(); ++e)
      for (std::size_t family = 0; family < 2; ++family) {
        const int here = of_quarter.of[2 * e + family], there = of_whole.of[2 * in_whole.at(place(quarter, e)) + family];
        EXPECT_EQ(one_way.try_emplace(here, there).first->second, there);
        EXPECT_EQ(other_way.try_emplace(there, here).first->second, here);
      }
  }
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
