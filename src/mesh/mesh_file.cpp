#include "mesh/mesh_file.hpp"
#include "towform/error.hpp"
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace towform {

std::string read_mesh_file(const std::filesystem::path& path, const std::string& kind)
{
  namespace fs = std::filesystem;
  const std::string name = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw FileError(fmt::format("{}: no such file; check the mesh's path", name));
  if (fs::is_directory(status))
    throw FileError(fmt::format("{}: is a directory; give the path of {}", name, kind));
  if (!fs::is_regular_file(status))
    throw FileError(fmt::format("{}: is not a regular file; give the path of {}", name, kind));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("{}: cannot be opened: {}", name, std::strerror(errno)));
  std::string bytes(fs::file_size(path, error), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw FileError(fmt::format("{}: cannot be read to its end: {}", name, std::strerror(errno)));
  if (bytes.empty()) throw FileError(fmt::format("{}: is empty; export the mesh again", name));
  return bytes;
}

} // namespace towform
