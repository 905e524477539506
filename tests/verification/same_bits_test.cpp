#include "hemisphere_case.hpp"
#include <cstring>
#include <gtest/gtest.h>

namespace towform {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST_F(CoarseHemisphere, HasTheSameBitsOnAnyNumberOfThreads)
{
  const std::vector<std::string> variants{"material.law=viscous", "material.law=incremental",
                                          "material.bending_stiffness=2 mN m"};
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const auto on = [&](int threads) { return fmt::format("{}_{}", v, threads); };
    const std::vector<std::string> overrides{variants[v]};
    const Summary one = form(on(1), 1, overrides);
    EXPECT_EQ(one.threads, 1);
    EXPECT_GT(one.shear_angle_max_deg, 2.0); // something has been formed
    for (const int threads : {2, 3, 4}) {
      const Summary more = form(on(threads), threads, overrides);
      EXPECT_EQ(more.threads, threads);
      EXPECT_EQ(more.steps, one.steps);
      EXPECT_EQ(more.energies_J, one.energies_J) << threads << " threads"; // to the bit
      EXPECT_EQ(text_of(directory / on(threads) / "history.csv"), text_of(directory / on(1) / "history.csv"));
      for (int frame = 0; frame <= 4; ++frame)
        for (const char* field : {"position", "velocity", "contact_pressure", "shear_angle", "shear_force",
                                  "clearance", "curvature"}) {
          const std::string dataset = fmt::format("frames/{:04}/{}", frame, field);
          EXPECT_TRUE(same_bits(values(on(threads), dataset), values(on(1), dataset)))
              << dataset << " on " << threads << " threads, " << variants[v];
        }
    }
  }
}

} // namespace
} // namespace towform
