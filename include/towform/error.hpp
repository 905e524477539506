#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace towform {

/// What the program returns to the shell.
enum class ExitCode {
  done = 0,
  usage = 2,
  case_file = 3,
  files = 4,
  stability_gate = 5,
  contact_gate = 6,
  checkpoint = 7,
  comparison = 8,
  our_bug = 70,
  interrupted = 75,
};

/// A place in an input text. Line and column count from 1; 0 means the file as a whole.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One thing wrong with the input; `text()` is `file:line:column: message`.
struct InputIssue {
  SourceLocation where;
  std::string message;
  ExitCode code = ExitCode::case_file; ///< case_file or files

  [[nodiscard]] std::string text() const;
};

/// Everything wrong with the input, all at once. Exit code: `case_file` when any issue is one, else `files`.
class InputError : public std::runtime_error {
public:
  explicit InputError(std::vector<InputIssue> issues);
  [[nodiscard]] const std::vector<InputIssue>& issues() const { return issues_; }
  [[nodiscard]] ExitCode code() const;

private:
  std::vector<InputIssue> issues_;
};

/// A file that cannot be read or written, outside a case file's keys; exit code `files`.
class FileError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A checkpoint that cannot be gone on from: damaged, or of another case; exit code `checkpoint`.
class CheckpointError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A run stopped by a gate; the message names the element, node or tool and the time.
class RunStopped : public std::runtime_error {
public:
  RunStopped(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

private:
  ExitCode code_;
};

} // namespace towform
