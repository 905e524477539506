#include "hemisphere_case.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

class LastDigit : public CoarseHemisphere {
protected:
  /// How far apart two sheets come out whose thicknesses differ in the last digit [m, RMS].
  [[nodiscard]] double apart(const std::vector<std::string>& overrides) const
  {
    for (const char* thickness : {"1", "1.000000000000003"}) {
      std::vector<std::string> all = overrides;
      all.emplace_back("blank.elements=2000"); // enough nodes that graze a tool
      all.push_back(fmt::format("blank.thickness={} mm", thickness));
      form(thickness, 1, all);
    }
    const std::vector<double> a = values("1", "frames/0004/position"), b = values("1.000000000000003", "frames/0004/position");
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    for (const char* name : {"1", "1.000000000000003"}) std::filesystem::remove_all(directory / name);
    return std::sqrt(3.0 * squares / static_cast<double>(a.size()));
  }
};

TEST_F(LastDigit, DoesNotDecideHowASheetIsFormed)
{
  const double soft = apart({}), stiff = apart({"contact.soft=1"});
  EXPECT_LT(soft, 1e-14);
  EXPECT_GT(stiff, 100.0 * soft); // nodes bounce off the tools
}

} // namespace
} // namespace towform
