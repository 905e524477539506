#pragma once
#include <string>

namespace towform {

/// The JSON Schema of a case file (draft 7), from the table that also reads the case: editors complete keys,
/// show their meaning and mark what is wrong while a case is written.
std::string case_schema();

} // namespace towform
