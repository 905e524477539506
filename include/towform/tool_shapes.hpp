#pragma once
#include "towform/surface_mesh.hpp"
#include <functional>
#include <string>
#include <vector>

namespace towform {

/// One named number of a tool shape, as an option of `towform mesh SHAPE` offers it.
struct ShapeParameter {
  std::string name;            ///< the option without its dashes, e.g. "dome-radius"
  double value = 0.0;          ///< default, m or rad
  double min = 0.0, max = 0.0; ///< allowed range, ends included, m or rad
  bool is_angle = false;       ///< rad; otherwise a length in m
  std::string meaning;         ///< one line; says "assumed" or "known" where the physics page does
};

/// A family of matching tools (punch, die, holder) around a flat sheet whose mid-plane is z = 0, in the start
/// position: the punch stands on the sheet and comes down, the die and the holder touch the sheet's faces.
struct ToolShape {
  std::string name;    ///< as in `towform mesh NAME`
  std::string meaning; ///< one line
  std::vector<std::string> parts;
  std::vector<ShapeParameter> parameters;
  /// The unchecked builder behind `build`.
  std::function<SurfaceMesh(const std::string& part, const std::vector<double>& values)> builder;

  /// A closed, welded surface, exactly mirror-symmetric in x and in y. `values` in the order of `parameters`.
  /// Throws std::invalid_argument: unknown part, a value outside its range, values that contradict each
  /// other.
  [[nodiscard]] SurfaceMesh build(const std::string& part, const std::vector<double>& values) const;

  /// The same with every parameter at its default.
  [[nodiscard]] SurfaceMesh build(const std::string& part) const;

  [[nodiscard]] std::vector<double> defaults() const;
};

/// Every shape the program can make.
const std::vector<ToolShape>& tool_shapes();

} // namespace towform
