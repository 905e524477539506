#include "mesh/msh_lines.hpp"
#include "case/file_issue.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {
constexpr std::string_view blanks = " \t\r\v\f";

/// For a message: short, and without bytes that are no text.
std::string shown(std::string_view text)
{
  std::string result(text.substr(0, 40));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + result + (text.size() > 40 ? "...'" : "'");
}
} // namespace

bool MshLines::next()
{
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    ++number_;
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) continue;
    line_ = line.substr(first, line.find_last_not_of(blanks) + 1 - first);
    return true;
  }
  line_ = {};
  return false;
}

void MshLines::expect_line(const std::string& wanted)
{
  if (!next())
    fail(fmt::format("the file ends where {} should follow: it is truncated, export it again", wanted));
}

template <class Number>
void MshLines::read_numbers(std::vector<Number>& numbers, std::size_t least, const std::string& what)
{
  numbers.clear();
  for (std::size_t at = 0; at < line_.size();) {
    const std::size_t end = std::min(line_.find_first_of(blanks, at), line_.size());
    std::string_view word = line_.substr(at, end - at);
    at = std::min(line_.find_first_not_of(blanks, end), line_.size());
    const std::string_view whole = word;
    if (word.starts_with('+')) word.remove_prefix(1);
    Number number{};
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || stop != word.data() + word.size())
      fail(fmt::format("{} is not a {}number: the line should hold {}", shown(whole),
                       std::is_integral_v<Number> ? "whole " : "", what));
    if constexpr (std::is_floating_point_v<Number>)
      if (!std::isfinite(number))
        fail(fmt::format("{} is not a finite number; export the mesh again", shown(whole)));
    numbers.push_back(number);
  }
  if (numbers.size() < least) fail(fmt::format("{} should hold {}", shown(line_), what));
}

const std::vector<std::int64_t>& MshLines::whole_numbers(std::size_t least, const std::string& what)
{
  read_numbers(whole_, least, what);
  return whole_;
}

const std::vector<double>& MshLines::reals(std::size_t least, const std::string& what)
{
  read_numbers(reals_, least, what);
  return reals_;
}

void MshLines::fail_at(int line, const std::string& message) const
{
  refuse_line(name_, std::max(line, 1), message);
}

} // namespace towform
