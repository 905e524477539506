#include "output/text_file.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace towform {

namespace {

/// A whole number (a step, a count) in full, anything else to nine digits.
std::string printed(double value)
{
  constexpr double exact = 9007199254740992.0; // 2^53: every whole number up to here is a double
  if (value == 0.0) return "0";                // not "-0"
  if (std::trunc(value) == value && std::abs(value) < exact) return fmt::format("{:.0f}", value);
  return fmt::format("{:.9g}", value);
}

/// A name that holds a comma, a quote or a line's end is quoted, as in RFC 4180.
std::string quoted(const std::string& name)
{
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + '"';
}

void add_cell(std::string& line, const std::string& cell)
{
  if (!line.empty()) line += ',';
  line += cell;
}

/// Opened and closed for each line: the row is with the system before the run goes on.
void write_line(const std::filesystem::path& path, std::ios::openmode mode, const std::string& line)
{
  errno = 0;
  std::ofstream file(path, std::ios::binary | mode);
  file << line << '\n';
  file.close();
  if (!file)
    throw FileError(
        fmt::format("{}: cannot be written: {}", path.string(), std::generic_category().message(errno)));
}

std::string first_line(const std::vector<std::string>& columns)
{
  std::string line;
  for (const std::string& name : columns) add_cell(line, quoted(name));
  return line;
}

} // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& columns)
    : path_(path), columns_(columns.size())
{
  if (path_.has_parent_path()) make_directory(path_.parent_path());
  write_line(path_, std::ios::trunc, first_line(columns));
}

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& columns,
                             std::int64_t rows)
    : path_(path), columns_(columns.size())
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw FileError(
        fmt::format("{}: cannot be opened: {}", path.string(), std::generic_category().message(errno)));
  std::string line;
  std::uintmax_t kept = 0;
  for (std::int64_t i = 0; i <= rows; ++i) {
    if (!std::getline(file, line) || file.eof())
      throw FileError(fmt::format("{}: has {} whole rows where the checkpoint was written after {}",
                                  path.string(), std::max<std::int64_t>(i - 1, 0), rows));
    if (i == 0 && line != first_line(columns))
      throw FileError(fmt::format("{}: has other columns than this run", path.string()));
    kept += line.size() + 1;
  }
  file.close();
  std::error_code error;
  std::filesystem::resize_file(path, kept, error);
  if (error) throw FileError(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
}

void HistoryWriter::append(const std::vector<double>& row)
{
  if (row.size() != columns_)
    throw std::invalid_argument(fmt::format("history: {} values for {} columns", row.size(), columns_));
  std::string line;
  for (const double value : row) add_cell(line, printed(value));
  write_line(path_, std::ios::app, line);
}

} // namespace towform
