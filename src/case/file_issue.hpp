#pragma once
#include "towform/error.hpp"
#include <string>

namespace towform {

/// What is wrong on a line of a data file, code `files`; line 0 for the file as a whole.
InputIssue file_issue(const std::string& file, int line, const std::string& message);

/// Throws InputError with that one issue.
[[noreturn]] void refuse_line(const std::string& file, int line, const std::string& message);

} // namespace towform
