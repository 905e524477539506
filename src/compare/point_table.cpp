#include "compare/point_table.hpp"
#include "case/file_issue.hpp"
#include "case/text_file.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <sstream>

namespace towform {

namespace {

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// Nothing when a quote is left open.
std::optional<std::vector<std::string>> cells_of(const std::string& line)
{
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[i++]; // "" inside quotes
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  if (quoted) return std::nullopt;
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

} // namespace

int PointTable::column(const std::string& name) const
{
  const auto found = std::find(columns.begin(), columns.end(), name);
  return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
}

bool read_number(const std::string& cell, double& value)
{
  const char *begin = cell.data(), *end = begin + cell.size();
  if (cell.starts_with('+') && !cell.starts_with("+-")) ++begin;
  const auto [rest, error] = std::from_chars(begin, end, value);
  return error == std::errc{} && rest == end && std::isfinite(value);
}

PointTable read_points(const std::filesystem::path& path)
{
  PointTable table;
  table.file = path.string();
  std::vector<InputIssue> issues;
  int number = 0;
  const auto issue = [&](const std::string& message) {
    issues.push_back(file_issue(table.file, number, message));
  };
  std::string content = read_text(path, "file of points");
  if (content.starts_with("\xef\xbb\xbf")) content.erase(0, 3); // a byte order mark, as spreadsheets write
  std::istringstream text(content);
  constexpr std::size_t enough = 20; // issues
  for (std::string line; std::getline(text, line) && issues.size() < enough;) {
    ++number;
    const std::string bare = trimmed(line);
    if (bare.empty() || bare.starts_with('#')) continue;
    const auto cells = cells_of(bare);
    if (!cells) {
      issue("a quotation mark is not closed");
    } else if (table.columns.empty()) {
      table.columns = *cells;
      table.header_line = number;
      for (std::size_t i = 0; i < cells->size(); ++i) {
        if ((*cells)[i].empty())
          issue(fmt::format("column {} has no name: the first line names the columns", i + 1));
        if (std::find(cells->begin(), cells->begin() + static_cast<std::ptrdiff_t>(i), (*cells)[i]) !=
            cells->begin() + static_cast<std::ptrdiff_t>(i))
          issue(fmt::format("column `{}` twice", (*cells)[i]));
      }
    } else if (cells->size() != table.columns.size()) {
      issue(fmt::format("{} values for {} columns", cells->size(), table.columns.size()));
    } else {
      table.rows.push_back({number, *cells});
    }
  }
  number = 0;
  if (issues.empty() && table.rows.empty()) issue("holds no points");
  if (!issues.empty()) throw InputError(std::move(issues));
  return table;
}

} // namespace towform
