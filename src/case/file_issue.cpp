#include "file_issue.hpp"

namespace towform {

InputIssue file_issue(const std::string& file, int line, const std::string& message)
{
  InputIssue issue;
  issue.where = {file, line, line == 0 ? 0 : 1};
  issue.message = message;
  issue.code = ExitCode::files;
  return issue;
}

void refuse_line(const std::string& file, int line, const std::string& message)
{
  throw InputError({file_issue(file, line, message)});
}

} // namespace towform
