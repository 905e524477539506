#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace towform {

/// A CSV file of points as read: columns named by its first line, cells as text, rows with their lines.
struct PointTable {
  struct Row {
    int line = 0;
    std::vector<std::string> cells; ///< one a column, without the blanks round it
  };
  std::string file;
  int header_line = 0;
  std::vector<std::string> columns;
  std::vector<Row> rows;

  [[nodiscard]] int column(const std::string& name) const; ///< its place, or -1
};

/// Reads a CSV file: commas between cells, cells perhaps in double quotes, lines with # in front and empty
/// ones passed over. Throws InputError, code `files`, with every issue found and its line: nothing in it, a
/// column without a name or named twice, rows with more or fewer cells than columns, unclosed quotes.
PointTable read_points(const std::filesystem::path& path);

/// A whole cell as a finite number; false when it is none.
bool read_number(const std::string& cell, double& value);

} // namespace towform
