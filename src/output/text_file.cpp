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

void reserve_space(const fs::path& path, std::size_t bytes)
{
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0)
    throw FileError(
        fmt::format("{}: cannot be opened: {}", path.string(), std::generic_category().message(errno)));
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
