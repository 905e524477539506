#include "document.hpp"
#include "float_traps.hpp"
#include "units.hpp"
#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <toml++/toml.h> // heavy: nowhere else

namespace towform {

namespace {

SourceLocation location(const toml::source_region& region, const std::string& file)
{
  return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Value converted(const toml::node& node, const std::string& file)
{
  Value value;
  value.where = value.key_where = location(node.source(), file);
  if (const toml::table* table = node.as_table()) {
    value.kind = Value::Kind::table;
    for (const auto& [key, item] : *table) {
      value.items.push_back(converted(item, file));
      value.items.back().key = std::string(key.str());
      value.items.back().key_where = location(key.source(), file);
    }
  } else if (const toml::array* list = node.as_array()) {
    value.kind = Value::Kind::list;
    for (const toml::node& item : *list) value.items.push_back(converted(item, file));
  } else if (const auto* text = node.as_string()) {
    value.kind = Value::Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Value::Kind::integer;
    value.integer = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = Value::Kind::number;
    value.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Value::Kind::boolean;
    value.boolean = boolean->get();
  } else {
    value.kind = Value::Kind::date;
  }
  return value;
}

void move_to(Value& value, const SourceLocation& where)
{
  value.where = value.key_where = where;
  for (Value& item : value.items) move_to(item, where);
}

/// Line of a key of absurdly many parts, on which the parser would exhaust the stack; 0 without one.
int line_of_endless_key(const std::string& text)
{
  int line = 1, dots = 0;
  for (const char c : text) {
    const bool of_key =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("._- \t\"'", c) != nullptr;
    dots = of_key ? dots + (c == '.' ? 1 : 0) : 0;
    if (dots > 1000) return line;
    if (c == '\n') ++line;
  }
  return 0;
}

std::string line_of(const std::string& text, int number)
{
  std::size_t start = 0;
  for (int line = 1; line < number && start < text.size(); ++line)
    start = std::min(text.find('\n', start), text.size() - 1) + 1;
  return text.substr(start, text.find('\n', start) - start);
}

/// The commonest slip in a case file: a unit outside quotes.
std::string hint_on(const std::string& line)
{
  std::size_t i = line.find('=');
  while (i < line.size()) {
    i = line.find_first_not_of(" \t", i + 1);
    const std::size_t number_end = std::min(line.find_first_not_of("+-.0123456789", i), line.size());
    const std::size_t unit = std::min(line.find_first_not_of(" \t", number_end), line.size());
    const auto is_letter = [&](std::size_t k) {
      return k < line.size() && (std::isalpha(static_cast<unsigned char>(line[k])) != 0 || line[k] == '%');
    };
    if (number_end > i && is_letter(unit)) {
      std::size_t unit_end = unit;
      while (is_letter(unit_end) || (unit_end < line.size() && line[unit_end] == '/')) ++unit_end;
      return fmt::format("; a value with a unit is written in quotes: \"{} {}\"",
                         line.substr(i, number_end - i), line.substr(unit, unit_end - unit));
    }
    i = line.find_first_of("=[,", i);
  }
  return "";
}

} // namespace

const Value* Value::find(const std::string& name) const
{
  if (!is_table()) return nullptr;
  const auto found = std::find_if(items.begin(), items.end(), [&](const Value& v) { return v.key == name; });
  return found == items.end() ? nullptr : &*found;
}

Value* Value::find(const std::string& name)
{
  return const_cast<Value*>(static_cast<const Value*>(this)->find(name));
}

std::string Value::shown() const
{
  switch (kind) {
  case Kind::text:
    return text.size() <= 40 ? in_quotes(text) : in_quotes(text.substr(0, 37) + "...");
  case Kind::integer:
    return fmt::format("{}", integer);
  case Kind::number:
    return written(number, Dimension::none);
  case Kind::boolean:
    return boolean ? "true" : "false";
  case Kind::date:
    return "a date";
  case Kind::list:
    return fmt::format("a list of {}", items.size());
  case Kind::table:
    return "a table";
  }
  return "";
}

namespace {
toml::table parsed(const std::string& text)
{
  const UntrappedFloats untrapped; // the text may hold 1e999
  return toml::parse(std::string_view(text));
}
} // namespace

Value parse_document(const std::string& text, const std::string& file)
{
  if (const int line = line_of_endless_key(text); line > 0) {
    const SourceLocation where{file, line, 1};
    throw InputError({{where, "not TOML: a key with more than 1000 parts"}});
  }
  try {
    return converted(parsed(text), file);
  } catch (const toml::parse_error& error) {
    std::string message(error.description());
    for (const std::string& prefix : {std::string("Error while parsing "), std::string("key-value pair: ")}) {
      if (message.starts_with(prefix)) message.erase(0, prefix.size());
    }
    // What the parser says of a string that goes on to the end of its line.
    if (message.find("control characters") != std::string::npos && message.starts_with("string"))
      message += "; is a closing quote missing?";
    const SourceLocation where = location(error.source(), file);
    throw InputError({{where, "not TOML: " + message + hint_on(line_of(text, where.line))}});
  }
}

Value parse_value(const std::string& text, const SourceLocation& where)
{
  Value value;
  value.kind = Value::Kind::text;
  value.text = text;
  try {
    const toml::table document = parsed("value = " + text);
    // More keys mean that the text went on after a line's end: it was not one value.
    if (document.size() == 1 && document.contains("value"))
      value = converted(*document.get("value"), where.file);
  } catch (const toml::parse_error&) {
    // Plain text, such as a quantity without its quotes.
  }
  move_to(value, where);
  return value;
}

std::string in_quotes(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (c == '\n')
      result += "\\n";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

} // namespace towform
