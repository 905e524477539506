#pragma once
#include <filesystem>

namespace towform {

/// Throws FileError, naming what is there and what can be done, when a directory holds the results or a
/// checkpoint of an earlier run.
void refuse_earlier_results(const std::filesystem::path& directory);

/// Whether a run has the directory now.
bool is_in_use(const std::filesystem::path& directory);

/// A directory that one run has for itself: made when missing, locked until this object goes or the process
/// dies. Throws FileError when it cannot be made or written, or while another run has it.
class OutputDirectory {
public:
  explicit OutputDirectory(const std::filesystem::path& directory);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

private:
  std::filesystem::path lock_;
  int file_ = -1;
};

} // namespace towform
