#include "mesh/tool_shapes_helpers.hpp"
#include <gtest/gtest.h>
#include <ostream>
#include <set>
#include <tuple>

namespace towform::tool_tests {
namespace {

struct Case {
  std::string shape, part;
  Changes changes;
};

std::string described(const std::string& shape, const std::string& part, const Changes& changes)
{
  std::string text = shape + " " + part;
  for (const auto& [name, value] : changes) text += " " + name + "=" + std::to_string(value);
  return text;
}
void PrintTo(const Case& c, std::ostream* out) { *out << described(c.shape, c.part, c.changes); }

std::vector<Case> cases()
{
  const std::vector<std::pair<std::string, Changes>> sets{
      {"double-dome", {}},
      {"double-dome", {{"draft", 0.0}, {"waist-half-width", 65 * mm}}},
      {"double-dome", {{"draft", 30 * degree}, {"depth", 150 * mm}, {"chord-error", 0.2 * mm}}},
      {"double-dome", {{"depth", 20 * mm}, {"skirt", 5 * mm}, {"sheet-thickness", 2 * mm}}},
      {"double-dome", {{"flange-length", 470 * mm}, {"flange-width", 270 * mm}, {"chord-error", 0.1 * mm}}},
      {"double-dome", {{"waist-half-width", 35 * mm}, {"chord-error", 0.05 * mm}}},
      {"double-dome", {{"dome-distance", 60 * mm}, {"waist-half-width", 62 * mm}, {"chord-error", 1 * mm}}},
      {"double-dome", {{"dome-distance", 500 * mm}, {"draft", 17 * degree}, {"chord-error", 0.5 * mm}}},
      {"hemisphere", {}},
      {"hemisphere", {{"opening-radius", 150 * mm}, {"chord-error", 0.1 * mm}}},
      {"hemisphere", {{"depth", 90 * mm}, {"chord-error", 0.5 * mm}, {"flange-width", 220 * mm}}},
      {"hemisphere", {{"dome-radius", 30 * mm}, {"holder-clearance", 5 * mm}, {"flange-length", 900 * mm}}},
      {"male-dome", {}},
      {"male-dome", {{"line-length", 200 * mm}, {"height", 40 * mm}, {"gap", 20 * mm}}},
      {"male-dome", {{"crown", 60 * mm}, {"chord-error", 0.5 * mm}}},
  };
  std::vector<Case> all;
  for (const auto& [name, changes] : sets)
    for (const std::string& part : shape(name).parts) all.push_back({name, part, changes});
  return all;
}

class EveryTool : public ::testing::TestWithParam<Case> {
protected:
  SurfaceMesh mesh = build(GetParam().shape, GetParam().part, GetParam().changes);
};
INSTANTIATE_TEST_SUITE_P(ToolShapes, EveryTool, ::testing::ValuesIn(cases()), [](const auto& test) {
  std::string name = test.param.shape + "_" + test.param.part + "_" + std::to_string(test.index);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(EveryTool, IsClosedAndNowhereFoldsBack)
{
  // The sharpest edge wanted is a cap's rim on a shallow dome, 128 degrees between normals; a fold has 180.
  std::vector<double> angles;
  ASSERT_NO_THROW(angles = dihedral_angles(mesh));
  EXPECT_LT(*std::max_element(angles.begin(), angles.end()), 130 * degree);
  // Euler's formula: no handle but the opening of a ring.
  const bool ring =
      GetParam().part == "holder" || (GetParam().shape == "hemisphere" && GetParam().part == "die");
  const auto n = [](const auto& list) { return static_cast<int>(list.size()); };
  EXPECT_EQ(n(mesh.points) - n(angles) + n(mesh.triangles), ring ? 0 : 2);
  EXPECT_GT(volume(mesh), 0.0);
}

TEST_P(EveryTool, HasUsefulFacetsAndNoPointTwice)
{
  std::set<std::tuple<double, double, double>> seen;
  for (const Vec3& p : mesh.points) {
    ASSERT_TRUE(is_finite(p));
    EXPECT_TRUE(seen.insert({p.x, p.y, p.z}).second);
  }
  // Longest edge over altitude; 1.15 is equilateral. The sides of thin plates are the worst, and narrow
  // flanges.
  const double limit = GetParam().changes.empty() ? 4.5 : 20.0;
  std::set<int> used;
  for (const Triangle& t : mesh.triangles) {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, norm(mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]));
    EXPECT_LT(longest * longest / (2.0 * norm(area_vector(mesh, t))), limit);
    used.insert(t.begin(), t.end());
  }
  EXPECT_EQ(used.size(), mesh.points.size());
}

TEST_P(EveryTool, IsItsOwnMirrorImageToTheBit)
{
  std::map<std::tuple<double, double, double>, int> node;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    node[{mesh.points[i].x, mesh.points[i].y, mesh.points[i].z}] = static_cast<int>(i);
  const auto canonical = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::set<Triangle> facets;
  for (const Triangle& t : mesh.triangles) facets.insert(canonical(t));
  for (const auto& [sx, sy] : {std::pair(-1.0, 1.0), std::pair(1.0, -1.0)})
    for (const Triangle& t : mesh.triangles) {
      Triangle image{};
      for (int k = 0; k < 3; ++k) {
        const Vec3& p = mesh.points[t[k]];
        const auto found = node.find({sx * p.x, sy * p.y, p.z});
        ASSERT_NE(found, node.end());
        image[2 - k] = found->second; // reversed: a reflection turns the facet round
      }
      ASSERT_TRUE(facets.contains(canonical(image)));
    }
}

TEST(ToolShapes, VolumesAreThoseOfTheExactBodies)
{
  using std::numbers::pi;
  const double R = 75 * mm, b = 87.5 * mm, r = 7.5 * mm, plate = 340 * mm * 340 * mm;
  // A chord error of 0.02 mm over the curved area bounds the difference.
  EXPECT_NEAR(volume(build("hemisphere", "punch")), 2.0 / 3.0 * pi * R * R * R + pi * R * R * 20 * mm,
              0.02 * mm * (2.0 * pi * R * R + 2.0 * pi * R * 20 * mm));
  const double fillet_hole = pi * (b * b * r - b * pi * r * r / 2.0 + 2.0 / 3.0 * r * r * r);
  const double hole = pi * 80 * mm * 80 * mm * 32.5 * mm + fillet_hole;
  EXPECT_NEAR(volume(build("hemisphere", "die")), plate * 40 * mm - hole, 0.02 * mm * 2.0 * pi * b * 45 * mm);
  const double f = 5 * mm, c = b + f;
  const double rounded = pi * (c * c * f - c * pi * f * f / 2.0 + 2.0 / 3.0 * f * f * f);
  EXPECT_NEAR(volume(build("hemisphere", "holder")), plate * 10 * mm - rounded - pi * b * b * 5 * mm,
              0.02 * mm * 2.0 * pi * b * 13 * mm);
}

TEST(ToolShapes, StartsOnTheFacesOfTheSheet)
{
  for (const ToolShape& s : tool_shapes()) {
    const auto extent = [&](const std::string& part) {
      const SurfaceMesh m = build(s.name, part, {{"sheet-thickness", 2 * mm}});
      std::pair<double, double> z{1.0, -1.0};
      for (const Vec3& p : m.points) z = {std::min(z.first, p.z), std::max(z.second, p.z)};
      return z;
    };
    for (const std::string& part : s.parts) {
      const auto [lowest, highest] = extent(part);
      if (part == "die" || part == "mould")
        EXPECT_EQ(highest, -1 * mm) << s.name << " " << part;
      else
        EXPECT_EQ(lowest, 1 * mm) << s.name << " " << part;
    }
  }
}

TEST(ToolShapes, ApexIsRoundedBySixFacetsOrSo)
{
  for (const char* name : {"double-dome", "hemisphere"}) {
    const SurfaceMesh m = build(name, "punch");
    const double x = std::string(name) == "hemisphere" ? 0.0 : 120 * mm;
    int round_apex = 0;
    for (const Triangle& t : m.triangles)
      for (const int i : t) round_apex += m.points[i] == Vec3{x, 0.0, 0.5 * mm} ? 1 : 0;
    EXPECT_GE(round_apex, 5) << name;
    EXPECT_LE(round_apex, 8) << name;
  }
}

TEST(ToolShapes, SizesStayInHand)
{
  for (const ToolShape& s : tool_shapes())
    for (const std::string& part : s.parts) {
      const std::size_t facets = s.build(part).triangles.size();
      EXPECT_GT(facets, 5000U) << s.name << " " << part;
      EXPECT_LT(facets, 40000U) << s.name << " " << part;
    }
}

TEST(ToolShapes, TableIsInOrder)
{
  for (const ToolShape& s : tool_shapes()) {
    std::set<std::string> names;
    for (const ShapeParameter& p : s.parameters) {
      EXPECT_TRUE(names.insert(p.name).second) << p.name;
      EXPECT_EQ(p.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string::npos) << p.name;
      EXPECT_LE(p.min, p.value) << p.name;
      EXPECT_LE(p.value, p.max) << p.name;
      EXPECT_FALSE(p.meaning.empty()) << p.name;
    }
  }
}

struct Contradiction {
  std::string shape, part;
  Changes changes;
  std::vector<std::string> said; ///< in the message
};

void PrintTo(const Contradiction& c, std::ostream* out) { *out << described(c.shape, c.part, c.changes); }

class Contradictions : public ::testing::TestWithParam<Contradiction> {};
INSTANTIATE_TEST_SUITE_P(
    ToolShapes, Contradictions,
    ::testing::Values(
        Contradiction{"double-dome", "anvil", {}, {"anvil", "punch, die, holder"}},
        Contradiction{"double-dome", "punch", {{"draft", 40 * degree}}, {"draft = 40 deg", "30 deg"}},
        Contradiction{"double-dome", "punch", {{"depth", std::nan("")}}, {"depth = nan"}},
        Contradiction{
            "double-dome", "punch", {{"waist-half-width", 70 * mm}}, {"70 mm", "dome-radius = 65 mm"}},
        Contradiction{"double-dome", "die", {{"gap", 0.5 * mm}}, {"gap = 0.5 mm", "sheet-thickness = 1 mm"}},
        Contradiction{
            "double-dome", "die", {{"entry-fillet", 60 * mm}}, {"depth = 60 mm", "entry-fillet = 60 mm"}},
        Contradiction{"double-dome",
                      "die",
                      {{"dome-distance", 40 * mm}, {"waist-half-width", 45 * mm}},
                      {"gap + entry-fillet = 15 mm", "dome-distance = 40 mm"}},
        Contradiction{"double-dome", "die", {{"flange-length", 380 * mm}}, {"flange-length = 380 mm"}},
        Contradiction{"double-dome", "die", {{"flange-width", 150 * mm}}, {"flange-width = 150 mm"}},
        Contradiction{"double-dome", "holder", {{"holder-fillet", 10 * mm}}, {"holder-thickness = 10 mm"}},
        Contradiction{"double-dome", "holder", {{"holder-clearance", 190 * mm}}, {"flange-length = 700 mm"}},
        Contradiction{"double-dome",
                      "holder",
                      {{"dome-distance", 100 * mm}, {"holder-clearance", 60 * mm}},
                      {"holder-clearance + holder-fillet = 65 mm"}},
        Contradiction{"double-dome",
                      "holder",
                      {{"draft", 30 * degree}, {"skirt", 80 * mm}, {"holder-thickness", 60 * mm}},
                      {"holder-thickness", "opening"}},
        Contradiction{
            "hemisphere", "punch", {{"opening-radius", 75.5 * mm}}, {"75.5 mm", "dome-radius = 75 mm"}},
        Contradiction{"hemisphere", "die", {{"die-thickness", 7 * mm}}, {"die-thickness = 7 mm", "7.5 mm"}},
        Contradiction{"hemisphere", "die", {{"flange-width", 170 * mm}}, {"flange-width = 170 mm"}}));

TEST_P(Contradictions, AreNamedWithTheirValues)
{
  const Contradiction& c = GetParam();
  try {
    build(c.shape, c.part, c.changes);
    FAIL() << "built all the same";
  } catch (const std::invalid_argument& error) {
    for (const std::string& words : c.said)
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(ToolShapes, WantAValueForEveryParameter)
{
  std::vector<double> values = shape("hemisphere").defaults();
  values.push_back(0.0);
  EXPECT_THROW(static_cast<void>(shape("hemisphere").build("die", values)), std::invalid_argument);
  values.resize(values.size() - 2);
  EXPECT_THROW(static_cast<void>(shape("hemisphere").build("die", values)), std::invalid_argument);
}

} // namespace
} // namespace towform::tool_tests
