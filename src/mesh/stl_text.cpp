#include "mesh/stl_text.hpp"
#include "towform/error.hpp"
#include <charconv>
#include <fmt/format.h>

namespace towform {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

bool is_word(std::string_view token, std::string_view word)
{
  if (token.size() != word.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (lower(token[k]) != word[k]) return false;
  }
  return true;
}

class StlParser {
public:
  StlParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  SurfaceMesh parse()
  {
    advance();
    do {
      expect_with_name("solid");
      while (!is_word(token_, "endsolid")) facet();
      expect_with_name("endsolid");
    } while (!token_.empty());
    return std::move(mesh_);
  }

private:
  void facet()
  {
    if (!is_word(token_, "facet")) fail("'facet' or 'endsolid'");
    advance();
    expect("normal");
    for (int k = 0; k < 3; ++k) { // ignored, and often wrong: not even required to be numbers
      if (token_.empty()) fail("the three numbers of a normal");
      advance();
    }
    expect("outer");
    expect("loop");
    const int first = static_cast<int>(mesh_.points.size());
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = number(), y = number(), z = number();
      mesh_.points.push_back({x, y, z});
    }
    mesh_.triangles.push_back({first, first + 1, first + 2});
    expect("endloop");
    expect("endfacet");
  }

  double number()
  {
    std::string_view digits = token_;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0.0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (digits.empty() || stop != end || error != std::errc{}) fail("a number");
    if (!std::isfinite(value)) {
      throw FileError(
          fmt::format("{}:{}: facet {} has a coordinate that is not finite ('{}'); export the mesh "
                      "again",
                      name_, token_line_, mesh_.triangles.size() + 1, token_));
    }
    advance();
    return value;
  }

  void expect(std::string_view word)
  {
    if (!is_word(token_, word)) fail(fmt::format("'{}'", word));
    advance();
  }

  [[noreturn]] void fail(const std::string& wanted) const
  {
    if (token_.empty()) {
      throw FileError(
          fmt::format("{}:{}: the file ends where {} should follow; it is truncated, export it again", name_,
                      line_, wanted));
    }
    throw FileError(fmt::format("{}:{}: expected {}, found '{}'; this is not a valid ASCII STL file", name_,
                                token_line_, wanted, token_.substr(0, 40)));
  }

  void advance()
  {
    while (at_ < text_.size() && is_space(text_[at_])) {
      if (text_[at_++] == '\n') ++line_;
    }
    const std::size_t first = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    token_ = text_.substr(first, at_ - first);
    token_line_ = line_;
  }

  /// Passes a keyword and the name that fills the rest of its line.
  void expect_with_name(std::string_view word)
  {
    if (!is_word(token_, word)) fail(fmt::format("'{}'", word));
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    advance();
  }

  std::string_view text_, token_;
  std::string name_;
  std::size_t at_ = 0;
  int line_ = 1, token_line_ = 1;
  SurfaceMesh mesh_;
};

} // namespace

SurfaceMesh parse_stl_text(std::string_view text, const std::string& name)
{
  return StlParser(text, name).parse();
}

} // namespace towform
