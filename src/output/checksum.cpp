#include "output/checksum.hpp"
#include "towform/error.hpp"
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <libdeflate.h>
#include <system_error>
#include <vector>

namespace towform {

std::uint32_t crc32_of_file(const std::filesystem::path& path, std::uint64_t offset)
{
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  std::vector<char> part(1 << 20);
  std::uint32_t crc = 0;
  while (file) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    crc = libdeflate_crc32(crc, part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof())
    throw FileError(
        fmt::format("{}: cannot be read: {}", path.string(), std::generic_category().message(errno)));
  return crc;
}

} // namespace towform
