#include "hemisphere_case.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>

namespace towform {
namespace {

/// |shear| of every element of a run's last frame with the centre of the element on the flat blank.
struct Field {
  std::vector<Vec2> centre;
  std::vector<double> shear; ///< [deg]

  Field(const std::vector<double>& reference, const std::vector<double>& triangles,
        const std::vector<double>& angle)
  {
    for (std::size_t e = 0; e < angle.size(); ++e) {
      Vec2 sum;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = static_cast<std::size_t>(triangles[3 * e + k]);
        sum.x += reference[3 * node] / 3.0;
        sum.y += reference[3 * node + 1] / 3.0;
      }
      centre.push_back(sum);
      shear.push_back(std::abs(angle[e]));
    }
  }
};

class Quarter : public CoarseHemisphere {
protected:
  [[nodiscard]] Field field(const std::string& name) const
  {
    return {values(name, "mesh/reference"), values(name, "mesh/triangles"),
            values(name, "frames/0004/shear_angle")};
  }
  /// The rules hold for yarns along the planes of symmetry and for those that cross them at 45 degrees.
  void compare(double fibre_degrees)
  {
    const std::vector<std::string> overrides{fmt::format("blank.fibre_angle={} deg", fibre_degrees),
                                             fmt::format("blank.mesh_angle={} deg", -fibre_degrees)};
    const Summary of_whole = form("whole", 2, overrides);
    auto quarter_overrides = overrides;
    quarter_overrides.emplace_back("blank.symmetry=quarter");
    const Summary of_quarter = form("quarter", 2, quarter_overrides);
    EXPECT_EQ(4 * of_quarter.elements, of_whole.elements);
    const double work = of_whole.energies_J.back().second;
    ASSERT_EQ(of_whole.energies_J.back().first, "external");
    EXPECT_NEAR(of_quarter.energies_J.back().second, work, 0.01 * work); // steps differ, and nodes rattle
    const Field whole = field("whole"), quarter = field("quarter");

    // Quarter against whole, element by element.
    const auto key = [](const Vec2& c) { return std::pair(std::lround(1e7 * c.x), std::lround(1e7 * c.y)); };
    std::map<std::pair<long, long>, double> of_element;
    for (std::size_t e = 0; e < whole.shear.size(); ++e) of_element[key(whole.centre[e])] = whole.shear[e];
    double squares = 0.0;
    for (std::size_t e = 0; e < quarter.shear.size(); ++e)
      squares += std::pow(quarter.shear[e] - of_element.at(key(quarter.centre[e])), 2);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(quarter.shear.size())), 0.01); // degrees

    // The whole's quarters against each other: elements are of one size.
    std::map<std::pair<bool, bool>, std::vector<double>> parts;
    for (std::size_t e = 0; e < whole.shear.size(); ++e)
      parts[{whole.centre[e].x > 0.0, whole.centre[e].y > 0.0}].push_back(whole.shear[e]);
    const auto mean = [](const std::vector<double>& v) {
      return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
    };
    const double all = mean(whole.shear);
    EXPECT_GT(all, 0.3); // something has been formed
    for (const auto& [where, shear] : parts) EXPECT_NEAR(mean(shear), all, 0.01 * all);
  }
};

TEST_F(Quarter, ShearsAsTheWholeDoesWithYarnsAlongTheMirrors) { compare(0.0); }
TEST_F(Quarter, ShearsAsTheWholeDoesWithYarnsOnTheBias) { compare(45.0); }

} // namespace
} // namespace towform
