#pragma once
#include "document.hpp"
#include <string>

namespace towform {

/// The document as JSON with the place of everything, for readers of other TOML files of ours outside this
/// program: a value is {"value": …, "at": [line, column]}, where the value is a scalar, a list of values or
/// an object of them; the object's values also have "key_at". Numbers that JSON does not know (NaN, infinity)
/// and dates become null.
std::string document_json(const Value& document);

} // namespace towform
