#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace towform {

/// The lines of a text one after the other, blank ones left out, and the numbers on them. Every fault is an
/// InputError of the file, code `files`, with the line.
class MshLines {
public:
  MshLines(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Goes on to the next line; false at the end of the text.
  bool next();
  /// Goes on to the next line, which must be there: `wanted` says what it should hold.
  void expect_line(const std::string& wanted);
  [[nodiscard]] std::string_view line() const { return line_; } ///< without the blanks round it
  [[nodiscard]] int number() const { return number_; }          ///< of the line, from 1
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - at_; }

  /// The line's numbers; `what` names the line ("a node's x, y and z"). At least `least` of them.
  const std::vector<std::int64_t>& whole_numbers(std::size_t least, const std::string& what);
  const std::vector<double>& reals(std::size_t least, const std::string& what);

  [[noreturn]] void fail(const std::string& message) const { fail_at(number_, message); }
  [[noreturn]] void fail_at(int line, const std::string& message) const;

private:
  template <class Number>
  void read_numbers(std::vector<Number>& numbers, std::size_t least, const std::string& what);

  std::string_view text_, line_;
  std::string name_;
  std::size_t at_ = 0;
  int number_ = 0;
  std::vector<std::int64_t> whole_;
  std::vector<double> reals_;
};

} // namespace towform
