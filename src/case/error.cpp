#include "towform/error.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace towform {

std::string InputIssue::text() const
{
  if (where.line == 0) return fmt::format("{}: {}", where.file, message);
  return fmt::format("{}:{}:{}: {}", where.file, where.line, where.column, message);
}

namespace {
std::string joined(const std::vector<InputIssue>& issues)
{
  std::string text;
  for (const InputIssue& issue : issues) {
    if (!text.empty()) text += '\n';
    text += issue.text();
  }
  return text;
}
} // namespace

InputError::InputError(std::vector<InputIssue> issues)
    : std::runtime_error(joined(issues)), issues_(std::move(issues))
{
}

ExitCode InputError::code() const
{
  const bool any = std::any_of(issues_.begin(), issues_.end(),
                               [](const InputIssue& i) { return i.code == ExitCode::case_file; });
  return any ? ExitCode::case_file : ExitCode::files;
}

} // namespace towform
