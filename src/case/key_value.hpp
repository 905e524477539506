#pragma once
#include "document.hpp"
#include "key_table.hpp"

namespace towform {

/// Checks a key's value and writes it to the target; adds what is wrong to the issues.
void set_key(const Row& row, const Value& value, Target& target, std::vector<InputIssue>& issues);

/// The key's value in SI units as TOML; empty when it has none.
std::string get_key(const Row& row, Target& target);

/// "length", "two lengths", "whole number", "x | y | z".
std::string type_of(const Row& row);

/// The key as a user knows it: `tool.punch.friction`.
std::string label(const Row& row, const Target& target);

} // namespace towform
