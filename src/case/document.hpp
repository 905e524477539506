#pragma once
#include "towform/error.hpp"
#include <cstdint>
#include <string>
#include <vector>

namespace towform {

/// One value of a TOML document with the place it stands at; the only view of TOML outside document.cpp.
struct Value {
  enum class Kind { text, integer, number, boolean, date, list, table };
  Kind kind = Kind::table;
  std::string text;
  std::int64_t integer = 0;
  double number = 0.0;
  bool boolean = false;
  std::vector<Value> items; ///< of a list, in order, or of a table, each with its key
  std::string key;          ///< empty in a list
  SourceLocation where;     ///< of the value; of its header for a table
  SourceLocation key_where; ///< of its key

  [[nodiscard]] bool is_table() const { return kind == Kind::table; }
  [[nodiscard]] const Value* find(const std::string& name) const; ///< of a table; null when absent
  [[nodiscard]] Value* find(const std::string& name);
  [[nodiscard]] std::string shown() const; ///< short, for messages
};

/// The document in `text`, places named after `file`. Throws InputError with the syntax error.
Value parse_document(const std::string& text, const std::string& file);

/// A value as typed on a command line or kept as a default: TOML, or plain text when it is not TOML.
Value parse_value(const std::string& text, const SourceLocation& where);

/// A TOML string for `text`, in quotes.
std::string in_quotes(const std::string& text);

} // namespace towform
