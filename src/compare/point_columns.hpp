#pragma once
#include "compare/point_table.hpp"
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// What a column of points says.
enum class PointRole { x, y, z, arc, polar, shear };
inline constexpr std::size_t point_roles = 6;
std::string role_name(PointRole role); ///< "x", "arc", …

/// A point of the reference: the values of the roles that the file has, lengths in m, angles in deg.
struct ReferencePoint {
  int line = 0;
  std::array<double, point_roles> values{};

  [[nodiscard]] double operator[](PointRole role) const { return values[static_cast<std::size_t>(role)]; }
};

/// The points of a table, read by the names of its columns.
struct ReferencePoints {
  std::string file;
  int header_line = 0;
  std::array<bool, point_roles> has{};
  std::vector<ReferencePoint> points;

  [[nodiscard]] bool of(PointRole role) const { return has[static_cast<std::size_t>(role)]; }
};

/// Does the column's name end in a unit, as x_mm does?
bool names_unit(const std::string& column);

/// A role given to a column by hand, `--column shear=measured_deg`.
struct ColumnChoice {
  PointRole role;
  std::string column;
};

/// Throws std::invalid_argument when the text is no `ROLE=COLUMN`.
ColumnChoice read_column_choice(const std::string& text);

/// Finds the columns: x_mm, y_mm, z_mm, arc_mm (arc_length_mm), polar_deg (polar_angle_deg), shear_deg
/// (shear_angle_deg), with the units mm, cm, m or um of length and deg or rad of angle; other columns are
/// passed over. Throws InputError, code `files`, with every issue found and its line: a chosen column that is
/// not there, a name that is nearly one of these, a role without a unit or with a wrong one, two columns for
/// one role, cells that are no numbers.
ReferencePoints read_columns(const PointTable& table, const std::vector<ColumnChoice>& choices);

} // namespace towform
