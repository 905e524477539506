#include "output/text_file.hpp"
#include "towform/error.hpp"
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace towform {

namespace fs = std::filesystem;

void make_directory(const fs::path& directory)
{
  std::error_code error;
  if (fs::exists(directory, error) && !fs::is_directory(directory, error))
    throw FileError(fmt::format("{}: is a file, not a directory", directory.string()));
  fs::create_directories(directory, error);
  if (error)
    throw FileError(
        fmt::format("{}: the directory cannot be created: {}", directory.string(), error.message()));
}

void replace_file(const fs::path& path, std::string_view text)
{
  fs::path temporary = path;
  temporary += ".new";
  errno = 0;
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  std::error_code error;
  std::string reason;
  if (!file) {
    reason = std::generic_category().message(errno);
  } else {
    fs::rename(temporary, path, error);
    if (!error) return;
    reason = error.message();
  }
  fs::remove(temporary, error);
  throw FileError(fmt::format("{}: cannot be written: {}", path.string(), reason));
}

namespace {

[[noreturn]] void fail(const fs::path& path, const char* what)
{
  throw FileError(fmt::format("{}: {}: {}", path.string(), what, std::generic_category().message(errno)));
}

int open_file(const fs::path& path, int flags)
{
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) fail(path, "cannot be opened");
  return file;
}

} // namespace

void overwrite_start(const fs::path& path, std::string_view text)
{
  const int file = open_file(path, O_WRONLY);
  const ssize_t written = ::pwrite(file, text.data(), text.size(), 0);
  ::close(file);
  if (written != static_cast<ssize_t>(text.size())) fail(path, "cannot be written");
}

void sync_file(const fs::path& path)
{
  const int file = open_file(path, O_RDONLY);
  const int result = ::fsync(file);
  ::close(file);
  if (result != 0 && errno != EINVAL) fail(path, "cannot be written to the disk"); // EINVAL: it has none
}

void reserve_space(const fs::path& path, std::size_t bytes)
{
  const int file = open_file(path, O_WRONLY);
  const off_t end = ::lseek(file, 0, SEEK_END);
  int reason = EINTR;
  while (reason == EINTR) reason = ::posix_fallocate(file, end, static_cast<off_t>(bytes));
  const bool full =
      reason == ENOSPC || reason == EDQUOT || reason == EFBIG; // anything else: not supported here
  if (full && ::ftruncate(file, end) != 0) reason = errno;
  ::close(file);
  if (full)
    throw FileError(fmt::format("{}: no room for {} more bytes: {}", path.string(), bytes,
                                std::generic_category().message(reason)));
}

} // namespace towform
