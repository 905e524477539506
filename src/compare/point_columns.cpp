#include "compare/point_columns.hpp"
#include "case/file_issue.hpp"
#include "case/suggestion.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform {

namespace {

struct Unit {
  const char* name;
  bool angle;
  double factor; // to m or deg
};
constexpr std::array units{Unit{"mm", false, 1e-3}, Unit{"cm", false, 1e-2}, Unit{"m", false, 1.0},
                           Unit{"um", false, 1e-6}, Unit{"deg", true, 1.0},  Unit{"rad", true, 180.0 / M_PI}};

struct Name {
  const char* text;
  PointRole role;
};
constexpr std::array names{Name{"x", PointRole::x},
                           Name{"y", PointRole::y},
                           Name{"z", PointRole::z},
                           Name{"arc", PointRole::arc},
                           Name{"polar", PointRole::polar},
                           Name{"shear", PointRole::shear},
                           Name{"arc_length", PointRole::arc},
                           Name{"polar_angle", PointRole::polar},
                           Name{"shear_angle", PointRole::shear}};

bool is_angle(PointRole role) { return role == PointRole::polar || role == PointRole::shear; }

/// `polar_angle_deg` is `polar_angle` in deg; null when the last word is no unit.
std::pair<std::string, const Unit*> split(const std::string& column)
{
  const std::size_t at = column.rfind('_');
  if (at != std::string::npos)
    for (const Unit& unit : units)
      if (column.substr(at + 1) == unit.name) return {column.substr(0, at), &unit};
  return {column, nullptr};
}

std::optional<PointRole> role_of(const std::string& name)
{
  for (const Name& known : names)
    if (name == known.text) return known.role;
  return std::nullopt;
}

class Columns {
public:
  explicit Columns(const PointTable& table) : table_(table) { place_.fill(-1); }

  ReferencePoints read(const std::vector<ColumnChoice>& choices)
  {
    for (const ColumnChoice& choice : choices) choose(choice);
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::string name = split(table_.columns[i]).first;
      const auto role = role_of(name);
      if (!role) suspect(i, name, choices);
      if (role && !std::any_of(choices.begin(), choices.end(), [&](const auto& c) {
            return c.role == *role || c.column == table_.columns[i];
          }))
        take(*role, i);
    }
    if (!issues_.empty()) throw InputError(std::move(issues_));
    ReferencePoints result;
    result.file = table_.file;
    result.header_line = table_.header_line;
    for (std::size_t r = 0; r < point_roles; ++r) result.has[r] = place_[r] >= 0;
    for (const PointTable::Row& row : table_.rows) result.points.push_back(point(row));
    if (!issues_.empty()) throw InputError(std::move(issues_));
    return result;
  }

private:
  /// `shaer_deg` would pass for a column of no interest.
  void suspect(std::size_t column, const std::string& name, const std::vector<ColumnChoice>& choices)
  {
    constexpr std::size_t long_enough = 4; // to be taken for another by chance no more
    if (name.size() < long_enough) return;
    if (std::any_of(choices.begin(), choices.end(),
                    [&](const auto& c) { return c.column == table_.columns[column]; }))
      return;
    std::vector<std::string> known;
    known.reserve(names.size());
    for (const Name& n : names) known.emplace_back(n.text);
    if (const std::string near = nearest(name, known); !near.empty())
      issue(table_.header_line,
            fmt::format("unknown column `{}`; did you mean `{}{}`?", table_.columns[column], near,
                        table_.columns[column].substr(name.size())));
  }

  void choose(const ColumnChoice& choice)
  {
    const int column = table_.column(choice.column);
    if (column < 0)
      return issue(table_.header_line,
                   fmt::format("there is no column `{}` for {}; there are {}{}", choice.column,
                               role_name(choice.role), listed(table_.columns, "and"),
                               did_you_mean(nearest(choice.column, table_.columns))));
    take(choice.role, static_cast<std::size_t>(column));
  }

  void take(PointRole role, std::size_t column)
  {
    const std::string& name = table_.columns[column];
    const Unit* unit = split(name).second;
    const auto r = static_cast<std::size_t>(role);
    if (unit == nullptr)
      return issue(table_.header_line, fmt::format("column `{}` names no unit: call it {}_{}", name, name,
                                                   is_angle(role) ? "deg or _rad" : "mm, _cm, _m or _um"));
    if (unit->angle != is_angle(role))
      return issue(table_.header_line, fmt::format("column `{}`: {} is {}, not {}", name, role_name(role),
                                                   is_angle(role) ? "an angle" : "a length",
                                                   unit->angle ? "an angle" : "a length"));
    if (place_[r] >= 0)
      return issue(table_.header_line,
                   fmt::format("columns `{0}` and `{1}` both give {2}; choose with --column {2}={0}",
                               table_.columns[static_cast<std::size_t>(place_[r])], name, role_name(role)));
    place_[r] = static_cast<int>(column);
    factor_[r] = unit->factor;
  }

  ReferencePoint point(const PointTable::Row& row)
  {
    ReferencePoint p;
    p.line = row.line;
    for (std::size_t r = 0; r < point_roles; ++r) {
      if (place_[r] < 0) continue;
      const auto column = static_cast<std::size_t>(place_[r]);
      double value = 0.0;
      if (!read_number(row.cells[column], value) && issues_.size() < 20)
        issue(row.line, fmt::format("{}: `{}` is not a number", table_.columns[column], row.cells[column]));
      p.values[r] = factor_[r] * value;
    }
    return p;
  }

  void issue(int line, const std::string& message)
  {
    issues_.push_back(file_issue(table_.file, line, message));
  }

  const PointTable& table_;
  std::array<int, point_roles> place_{}; // columns; -1 for none
  std::array<double, point_roles> factor_{};
  std::vector<InputIssue> issues_;
};

} // namespace

bool names_unit(const std::string& column) { return split(column).second != nullptr; }

std::string role_name(PointRole role)
{
  return std::find_if(names.begin(), names.end(), [&](const Name& n) { return n.role == role; })->text;
}

ColumnChoice read_column_choice(const std::string& text)
{
  const std::size_t at = text.find('=');
  const auto role = role_of(text.substr(0, at));
  if (at == std::string::npos || at + 1 == text.size() || !role)
    throw std::invalid_argument(
        fmt::format("'{}': give ROLE=COLUMN, the role being x, y, z, arc, polar or shear", text));
  return {*role, text.substr(at + 1)};
}

ReferencePoints read_columns(const PointTable& table, const std::vector<ColumnChoice>& choices)
{
  return Columns(table).read(choices);
}

} // namespace towform
