#pragma once
#include "document.hpp"

namespace towform {

/// Puts `key.path=value` into the document, where it replaces or adds a key; tools and boundaries by their
/// name. A key that excludes another, as edge does elements, takes its place. What is wrong with the path's
/// form goes to the issues; whether its keys exist is for the readers of the document.
void apply_override(Value& document, const std::string& text, std::vector<InputIssue>& issues);

} // namespace towform
