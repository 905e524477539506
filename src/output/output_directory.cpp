#include "output/output_directory.hpp"
#include "output/checkpoint_file.hpp"
#include "output/text_file.hpp"
#include "towform/error.hpp"
#include <array>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace towform {

namespace fs = std::filesystem;

namespace {

fs::path lock_path(const fs::path& directory) { return directory / ".towform.lock"; }

std::string reason() { return std::generic_category().message(errno); }

/// Whether the file that is open is still the one of that name: its last owner may have removed it.
bool is_named(int file, const fs::path& path)
{
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

std::string owner(int file)
{
  std::array<char, 64> text{};
  const ssize_t length = ::pread(file, text.data(), text.size() - 1, 0);
  return length > 0 ? fmt::format(" (process {})", text.data()) : "";
}

} // namespace

void refuse_earlier_results(const fs::path& directory)
{
  std::error_code ignored;
  const bool resumable = fs::exists(checkpoint_path(directory), ignored) ||
                         fs::exists(previous_checkpoint_path(directory), ignored);
  const fs::path results = directory / "results.h5";
  if (!resumable && !fs::exists(results, ignored)) return;
  throw FileError(fmt::format(
      "{}: holds the {} of an earlier run: --force replaces them, -o takes another "
      "directory{}",
      directory.string(), resumable ? "results and a checkpoint" : "results",
      resumable ? fmt::format(", 'towform resume {}' goes on with that run", directory.string()) : ""));
}

bool is_in_use(const fs::path& directory)
{
  const int file = ::open(lock_path(directory).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool taken = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return taken;
}

namespace {
/// Whether the lock could be taken. Who looks whether a run has the directory holds it for a moment (is_in_use).
bool take_lock(int file)
{
  constexpr int tries = 5;
  constexpr std::chrono::milliseconds pause{2};
  for (int i = 1; ::flock(file, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (errno != EWOULDBLOCK || i == tries) return false;
    std::this_thread::sleep_for(pause);
  }
  return true;
}
} // namespace

OutputDirectory::OutputDirectory(const fs::path& directory) : lock_(lock_path(directory))
{
  make_directory(directory);
  while (true) {
    file_ = ::open(lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) throw FileError(fmt::format("{}: cannot be written: {}", directory.string(), reason()));
    if (!take_lock(file_)) {
      const std::string message =
          errno == EWOULDBLOCK
              ? fmt::format("{}: is in use by another run{}", directory.string(), owner(file_))
              : fmt::format("{}: cannot be locked: {}", directory.string(), reason());
      ::close(file_);
      throw FileError(message);
    }
    if (is_named(file_, lock_)) break;
    ::close(file_);
  }
  const std::string process = std::to_string(::getpid());
  if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, process.data(), process.size(), 0) < 0) {
    // A full disk: the lock holds without its owner's number.
  }
}

OutputDirectory::~OutputDirectory()
{
  ::unlink(lock_.c_str());
  ::close(file_);
}

} // namespace towform
