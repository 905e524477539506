#pragma once
#include "compare/point_table.hpp"
#include <string>
#include <vector>

namespace towform {

/// Chooses rows of a table: `COLUMN=VALUE`, or with !=, <, <=, > or >= in place of =; numbers are compared as
/// numbers, in the file's own unit.
struct Condition {
  enum class Relation { equal, unlike, less, at_most, more, at_least };
  std::string text, column, value;
  Relation relation = Relation::equal;
};

/// Throws std::invalid_argument when the text is no condition.
Condition read_condition(const std::string& text);

/// Keeps the rows that meet all conditions. Throws InputError, code `files`: an unknown column, a cell that
/// is no number where numbers are compared, no row left (what the column holds is listed), or a column of
/// words that tells sets apart and that no condition chooses from: two sets must not be mixed unawares.
void keep_rows(PointTable& table, const std::vector<Condition>& conditions);

} // namespace towform
