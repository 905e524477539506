#include "compare/condition.hpp"
#include "case/file_issue.hpp"
#include "case/suggestion.hpp"
#include "compare/point_columns.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace towform {

namespace {

using Relation = Condition::Relation;

[[noreturn]] void refuse(const PointTable& table, int line, const std::string& message)
{
  refuse_line(table.file, line, message);
}

template <class T>
bool holds(const T& a, Relation relation, const T& b)
{
  switch (relation) {
  case Relation::equal:
    return a == b;
  case Relation::unlike:
    return a != b;
  case Relation::less:
    return a < b;
  case Relation::at_most:
    return a <= b;
  case Relation::more:
    return a > b;
  case Relation::at_least:
    return a >= b;
  }
  return false;
}

/// The values of a column, each once, in the file's order.
std::vector<std::string> values_of(const PointTable& table, std::size_t column)
{
  std::vector<std::string> values;
  for (const PointTable::Row& row : table.rows)
    if (std::find(values.begin(), values.end(), row.cells[column]) == values.end())
      values.push_back(row.cells[column]);
  return values;
}

std::string some_of(std::vector<std::string> values)
{
  constexpr std::size_t most = 8;
  const bool more = values.size() > most;
  if (more) values.resize(most);
  return listed(values, "and") + (more ? " and more" : "");
}

bool meets(const PointTable& table, const PointTable::Row& row, std::size_t column,
           const Condition& condition)
{
  double cell = 0.0, value = 0.0;
  const bool number = read_number(row.cells[column], cell), to_number = read_number(condition.value, value);
  if (number && to_number) return holds(cell, condition.relation, value);
  if (condition.relation == Relation::equal || condition.relation == Relation::unlike)
    return holds(row.cells[column], condition.relation, condition.value);
  refuse(table, row.line,
         fmt::format("`{}` is not a number, which --where {} compares", row.cells[column], condition.text));
}

} // namespace

Condition read_condition(const std::string& text)
{
  const std::size_t at = text.find_first_of("=<>!");
  if (at == 0 || at == std::string::npos)
    throw std::invalid_argument(fmt::format("'{}' is no condition: COLUMN=VALUE is, or COLUMN<=VALUE", text));
  const std::string sign = text.substr(at, text.size() > at + 1 && text[at + 1] == '=' ? 2 : 1);
  static const std::vector<std::pair<std::string, Relation>> signs{
      {"=", Relation::equal},    {"==", Relation::equal}, {"!=", Relation::unlike},  {"<", Relation::less},
      {"<=", Relation::at_most}, {">", Relation::more},   {">=", Relation::at_least}};
  const auto found = std::find_if(signs.begin(), signs.end(), [&](const auto& s) { return s.first == sign; });
  if (found == signs.end()) throw std::invalid_argument(fmt::format("'{}': {} is no relation", text, sign));
  return {text, text.substr(0, at), text.substr(at + sign.size()), found->second};
}

void keep_rows(PointTable& table, const std::vector<Condition>& conditions)
{
  std::vector<std::size_t> chosen;
  for (const Condition& condition : conditions) {
    const int column = table.column(condition.column);
    if (column < 0)
      refuse(table, table.header_line,
             fmt::format("there is no column `{}` for --where; there are {}{}", condition.column,
                         listed(table.columns, "and"),
                         did_you_mean(nearest(condition.column, table.columns))));
    const auto place = static_cast<std::size_t>(column);
    chosen.push_back(place);
    const std::vector<std::string> before = values_of(table, place);
    std::erase_if(table.rows, [&](const auto& row) { return !meets(table, row, place, condition); });
    if (table.rows.empty())
      refuse(table, table.header_line,
             fmt::format("no row is left by --where {}; column `{}` holds {}", condition.text,
                         condition.column, some_of(before)));
  }
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (std::find(chosen.begin(), chosen.end(), column) != chosen.end()) continue;
    const std::vector<std::string> values = values_of(table, column);
    const bool words = !names_unit(table.columns[column]) &&
                       std::any_of(values.begin(), values.end(), [](const std::string& value) {
                         double unused = 0.0;
                         return !read_number(value, unused);
                       });
    if (words && values.size() > 1 && values.size() < table.rows.size())
      refuse(table, table.header_line,
             fmt::format("column `{0}` tells {1} sets apart, {2}: choose with --where {0}={3}",
                         table.columns[column], values.size(), some_of(values), values.front()));
  }
}

} // namespace towform
