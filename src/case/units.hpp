#pragma once
#include <string>
#include <vector>

namespace towform {

enum class Dimension {
  none,
  length,
  time,
  angle,
  angular_rate,
  velocity,
  force,
  pressure,
  temperature,
  viscosity,
  mass,
  density,
  molar_energy,
  bending_stiffness,
  curvature,
  acceleration,
  frequency,
};

std::string dimension_name(Dimension dimension);        ///< "length"
std::string si_unit(Dimension dimension);               ///< "m"; empty for none
std::vector<std::string> units_of(Dimension dimension); ///< those a user is told of
bool is_unit_of(const std::string& unit, Dimension dimension);

/// A number read from text, or what is wrong with it.
struct Quantity {
  double value = 0.0; ///< SI
  std::string problem;
};

/// "650 mm", "650mm", "30 %"; text must carry a unit unless the dimension is `none`.
Quantity read_quantity(const std::string& text, Dimension dimension);

/// The dimensions, other than `none`, in which `text` is a number with a unit.
std::vector<Dimension> dimensions_of(const std::string& text);

/// TOML for a value: a plain number when dimensionless, else a string with the SI unit. Reads back exactly.
std::string written(double value, Dimension dimension);

} // namespace towform
