#include "case/range.hpp"
#include "case/suggestion.hpp"
#include "case/units.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace towform {

using D = Dimension;

TEST(Units, ConvertToTheNearestDouble)
{
  const double pi = std::numbers::pi;
  const std::vector<std::tuple<std::string, D, double>> quantities{
      {"650 mm", D::length, 0.65},
      {"650mm", D::length, 0.65},
      {" +65 cm ", D::length, 0.65},
      {"17 um", D::length, 17e-6},
      {"17 \u00b5m", D::length, 17e-6},
      {"17 \u03bcm", D::length, 17e-6},
      {"2 in", D::length, 0.0508},
      {"1e-3m", D::length, 1e-3},
      {"60 ms", D::time, 0.06},
      {"3 us", D::time, 3e-6},
      {"2 min", D::time, 120.0},
      {"180 deg", D::angle, pi},
      {"90\u00b0", D::angle, pi / 2},
      {"180 deg/s", D::angular_rate, pi},
      {"3 rad / s", D::angular_rate, 3},
      {"6 mm/min", D::velocity, 1e-4},
      {"5 mm/s", D::velocity, 0.005},
      {"-35 N", D::force, -35.0},
      {"2 kN", D::force, 2000.0},
      {"5 mN", D::force, 0.005},
      {"1 GPa", D::pressure, 1e9},
      {"3 MPa", D::pressure, 3e6},
      {"4 kPa", D::pressure, 4e3},
      {"0 degC", D::temperature, 273.15},
      {"20 \u00b0C", D::temperature, 293.15},
      {"300 K", D::temperature, 300.0},
      {"300 Pa s", D::viscosity, 300.0},
      {"300 Pa.s", D::viscosity, 300.0},
      {"500 g", D::mass, 0.5},
      {"1.48 g/cm^3", D::density, 1480.0},
      {"1480 kg/m3", D::density, 1480.0},
      {"40 kJ/mol", D::molar_energy, 40000.0},
      {"5 1/s", D::frequency, 5.0},
      {"30 %", D::none, 0.3},
      {"0.25", D::none, 0.25},
  };
  for (const auto& [text, dimension, value] : quantities) {
    const Quantity got = read_quantity(text, dimension);
    EXPECT_EQ(got.problem, "") << text;
    EXPECT_DOUBLE_EQ(got.value, value) << text;
  }
  EXPECT_EQ(read_quantity("0.45 mm", D::length).value, 0.00045); // to the bit, unlike 0.45 * 1e-3
}

TEST(Units, RefuseWhatIsNoQuantity)
{
  for (const char* text : {"", " ", "mm", "5", "5 s", "5 mm mm", "five mm", "nan mm", "inf mm", "0x10 mm",
                           "--5 mm", "+-5 mm", "1e999 mm", "5 m m", "1,5 mm"})
    EXPECT_NE(read_quantity(text, D::length).problem, "") << text;
  EXPECT_NE(read_quantity("1e308 GPa", D::pressure).problem, "");
}

TEST(Units, WriteWhatReadsBackExactly)
{
  for (const double value : {0.1, 1.0 / 3.0, -2e-300, 1e300, 0.0, 463.15}) {
    for (int d = 0; d <= static_cast<int>(D::frequency); ++d) {
      std::string text = written(value, static_cast<D>(d));
      if (text.front() == '"') text = text.substr(1, text.size() - 2);
      EXPECT_EQ(read_quantity(text, static_cast<D>(d)).value, value) << text;
    }
  }
  EXPECT_EQ(written(1.0, D::none), "1.0"); // not a whole number in TOML
}

TEST(Range, ReadsTheTextOfTheReference)
{
  EXPECT_TRUE(Range("", D::length).contains(-1e300));
  EXPECT_FALSE(Range("> 0", D::length).contains(0.0));
  EXPECT_TRUE(Range(">= 0", D::length).contains(0.0));
  EXPECT_FALSE(Range("> 0, <= 0.9", D::none).contains(0.0));
  EXPECT_TRUE(Range("> 0, <= 0.9", D::none).contains(0.9));
  EXPECT_FALSE(Range("> 0, < 0.9", D::none).contains(0.9));
  EXPECT_TRUE(Range("1 um .. 0.1 m", D::length).contains(1e-6));
  EXPECT_FALSE(Range("1 um .. 0.1 m", D::length).contains(0.9e-6));
  EXPECT_FALSE(Range("1 um .. 0.1 m", D::length).contains(0.11));
  EXPECT_THROW(Range("about 3", D::none), std::logic_error);
}

TEST(Suggestion, NearWordsOnly)
{
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("daigonal", "diagonal"), 1); // a swap is one slip
  EXPECT_EQ(nearest("thicknes", {"size", "thickness"}), "thickness");
  EXPECT_EQ(nearest("Fibre-Angle", {"fibre_angle"}), "fibre_angle");
  EXPECT_EQ(nearest("width", {"size", "edge"}), "");
  EXPECT_EQ(nearest("z", {"x", "y"}), "");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b or c");
}

} // namespace towform
