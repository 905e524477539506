#include "units.hpp"
#include "document.hpp"
#include "float_traps.hpp"
#include "suggestion.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace towform {

namespace {

struct Unit {
  Dimension dimension;
  const char* name;
  double multiply; ///< value in SI = number * multiply / divide + offset; the pair keeps powers of ten exact
  double divide = 1.0; ///< (0.001 is not a binary number, 1000 is)
  double offset = 0.0;
  bool told = true; ///< false for another spelling of a unit above
};

constexpr double degree = std::numbers::pi / 180.0;
using D = Dimension;
// The SI unit of each dimension comes first.
constexpr std::array units{
    Unit{D::none, "%", 1, 100},
    Unit{D::length, "m", 1},
    Unit{D::length, "cm", 1, 100},
    Unit{D::length, "mm", 1, 1e3},
    Unit{D::length, "um", 1, 1e6},
    Unit{D::length, "\u00b5m", 1, 1e6},           // micro sign
    Unit{D::length, "\u03bcm", 1, 1e6, 0, false}, // Greek mu
    Unit{D::length, "in", 254, 1e4},
    Unit{D::time, "s", 1},
    Unit{D::time, "ms", 1, 1e3},
    Unit{D::time, "us", 1, 1e6},
    Unit{D::time, "\u00b5s", 1, 1e6},
    Unit{D::time, "\u03bcs", 1, 1e6, 0, false},
    Unit{D::time, "min", 60},
    Unit{D::time, "h", 3600},
    Unit{D::angle, "rad", 1},
    Unit{D::angle, "deg", degree},
    Unit{D::angle, "\u00b0", degree, 1, 0, false},
    Unit{D::angular_rate, "rad/s", 1},
    Unit{D::angular_rate, "deg/s", degree},
    Unit{D::angular_rate, "\u00b0/s", degree, 1, 0, false},
    Unit{D::velocity, "m/s", 1},
    Unit{D::velocity, "mm/s", 1, 1e3},
    Unit{D::velocity, "mm/min", 1, 6e4},
    Unit{D::force, "N", 1},
    Unit{D::force, "kN", 1e3},
    Unit{D::force, "mN", 1, 1e3},
    Unit{D::pressure, "Pa", 1},
    Unit{D::pressure, "kPa", 1e3},
    Unit{D::pressure, "MPa", 1e6},
    Unit{D::pressure, "GPa", 1e9},
    Unit{D::temperature, "K", 1},
    Unit{D::temperature, "degC", 1, 1, 273.15},
    Unit{D::temperature, "\u00b0C", 1, 1, 273.15, false},
    Unit{D::viscosity, "Pa s", 1},
    Unit{D::viscosity, "Pas", 1, 1, 0, false},
    Unit{D::viscosity, "Pa.s", 1, 1, 0, false},
    Unit{D::viscosity, "Pa*s", 1, 1, 0, false},
    Unit{D::viscosity, "Pa\u00b7s", 1, 1, 0, false},
    Unit{D::mass, "kg", 1},
    Unit{D::mass, "g", 1, 1e3},
    Unit{D::density, "kg/m^3", 1},
    Unit{D::density, "kg/m3", 1},
    Unit{D::density, "g/cm^3", 1e3},
    Unit{D::density, "g/cm3", 1e3, 1, 0, false},
    Unit{D::molar_energy, "J/mol", 1},
    Unit{D::molar_energy, "kJ/mol", 1e3},
    Unit{D::bending_stiffness, "N m", 1},
    Unit{D::bending_stiffness, "mN m", 1, 1e3},
    Unit{D::bending_stiffness, "N mm", 1, 1e3},
    Unit{D::bending_stiffness, "mN mm", 1, 1e6},
    Unit{D::bending_stiffness, "Nm", 1, 1, 0, false},
    Unit{D::bending_stiffness, "mNm", 1, 1e3, 0, false},
    Unit{D::bending_stiffness, "Nmm", 1, 1e3, 0, false},
    Unit{D::curvature, "1/m", 1},
    Unit{D::curvature, "1/mm", 1e3},
    Unit{D::acceleration, "m/s^2", 1},
    Unit{D::acceleration, "m/s2", 1},
    Unit{D::acceleration, "mm/s^2", 1, 1e3},
    Unit{D::acceleration, "mm/s2", 1, 1e3, 0, false},
    Unit{D::frequency, "1/s", 1},
};

/// Blanks collapsed to one, none round a slash.
std::string normal(const std::string& unit)
{
  std::string result;
  for (const char c : unit) {
    const bool blank = c == ' ' || c == '\t';
    if (blank && (result.empty() || result.back() == ' ' || result.back() == '/')) continue;
    if (c == '/' && !result.empty() && result.back() == ' ') result.pop_back();
    result += blank ? ' ' : c;
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

const Unit* find_unit(const std::string& name, Dimension dimension)
{
  const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) {
    return unit.dimension == dimension && unit.name == normal(name);
  });
  return found == units.end() ? nullptr : &*found;
}

struct Split {
  bool number = false, too_large = false;
  double value = 0.0;
  std::string unit;
};

Split split(const std::string& text)
{
  Split result;
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return result;
  const char* begin = text.data() + first;
  const char* end = text.data() + text.size();
  if (*begin == '+' && begin + 1 != end && begin[1] != '-') ++begin;
  const auto [rest, error] = std::from_chars(begin, end, result.value);
  result.number = error == std::errc{} && std::isfinite(result.value);
  result.too_large = error == std::errc::result_out_of_range;
  result.unit = error == std::errc::invalid_argument ? normal(text) : normal({rest, end});
  return result;
}

/// Units are told apart by capitals, but people forget them.
std::string same_letters(const std::string& name, Dimension dimension)
{
  for (const std::string& unit : units_of(dimension)) {
    const bool same =
        std::equal(name.begin(), name.end(), unit.begin(), unit.end(),
                   [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
    if (same) return did_you_mean(unit);
  }
  return "";
}

std::string article(const std::string& noun)
{
  return (noun.find_first_of("aeiou") == 0 ? "an " : "a ") + noun;
}

} // namespace

std::string dimension_name(Dimension dimension)
{
  switch (dimension) {
  case D::none:
    return "number";
  case D::length:
    return "length";
  case D::time:
    return "time";
  case D::angle:
    return "angle";
  case D::angular_rate:
    return "angular rate";
  case D::velocity:
    return "velocity";
  case D::force:
    return "force";
  case D::pressure:
    return "pressure";
  case D::temperature:
    return "temperature";
  case D::viscosity:
    return "viscosity";
  case D::mass:
    return "mass";
  case D::density:
    return "density";
  case D::molar_energy:
    return "molar energy";
  case D::bending_stiffness:
    return "bending stiffness";
  case D::curvature:
    return "curvature";
  case D::acceleration:
    return "acceleration";
  case D::frequency:
    return "frequency";
  }
  return "";
}

std::string si_unit(Dimension dimension) { return dimension == D::none ? "" : units_of(dimension).front(); }

std::vector<std::string> units_of(Dimension dimension)
{
  std::vector<std::string> names;
  for (const Unit& unit : units) {
    if (unit.dimension == dimension && unit.told) names.emplace_back(unit.name);
  }
  return names;
}

bool is_unit_of(const std::string& unit, Dimension dimension)
{
  return find_unit(unit, dimension) != nullptr;
}

std::vector<Dimension> dimensions_of(const std::string& text)
{
  std::vector<Dimension> found;
  const Split parts = split(text);
  if (!parts.number) return found;
  for (const Unit& unit : units) {
    if (unit.dimension != D::none && unit.name == parts.unit) found.push_back(unit.dimension);
  }
  return found;
}

Quantity read_quantity(const std::string& text, Dimension dimension)
{
  const Split parts = split(text);
  const std::string fitting = listed(units_of(dimension));
  const std::string what = dimension_name(dimension);
  if (parts.too_large) return {0, "is beyond the numbers a computer holds"};
  if (!parts.number) {
    return {0, dimension == D::none ? "is not a number"
                                    : fmt::format("is not {} (a number with {})", article(what), fitting)};
  }
  if (parts.unit.empty()) {
    if (dimension == D::none) return {parts.value, ""};
    return {0, fmt::format("has no unit; it is {}: {}", article(what), fitting)};
  }
  if (const Unit* unit = find_unit(parts.unit, dimension)) {
    const UntrappedFloats judging;
    const double value = parts.value * unit->multiply / unit->divide + unit->offset;
    if (!std::isfinite(value)) return {0, "is beyond the numbers a computer holds"};
    return {value, ""};
  }
  if (const std::vector<Dimension> others = dimensions_of(text); !others.empty()) {
    if (dimension == D::none)
      return {0, fmt::format("is {}; a plain number or % fits here", article(dimension_name(others[0])))};
    return {0,
            fmt::format("is {}, not {}; use {}", article(dimension_name(others[0])), article(what), fitting)};
  }
  if (dimension == D::none) return {0, fmt::format("has a unit; a plain number or % fits here")};
  return {0, fmt::format("has an unknown unit `{}`; use {}{}", parts.unit, fitting,
                         same_letters(parts.unit, dimension))};
}

std::string written(double value, Dimension dimension)
{
  std::string number = fmt::format("{}", value);
  if (dimension != D::none) return in_quotes(number + " " + si_unit(dimension));
  if (number.find_first_of(".en") == std::string::npos) number += ".0"; // a real number, not a whole one
  return number;
}

} // namespace towform
