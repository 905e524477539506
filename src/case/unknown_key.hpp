#pragma once
#include "document.hpp"

namespace towform {

/// Adds an issue, with a suggestion, for every key of `table` (whose path is `path`, empty for the whole
/// document) that no row of the key table has, and for tables that are something else.
void find_unknown_keys(const Value& table, const std::string& path, std::vector<InputIssue>& issues);

} // namespace towform
