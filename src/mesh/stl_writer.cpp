#include "towform/error.hpp"
#include "towform/surface_mesh.hpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace towform {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read and written as little-endian");

using Floats = std::array<float, 3>;

Floats single(const Vec3& p)
{
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

template <class T>
void append(std::string& bytes, const T& value)
{
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof value);
  std::memcpy(bytes.data() + end, &value, sizeof value);
}

} // namespace

void write_stl(const std::filesystem::path& path, const SurfaceMesh& mesh, const std::string& title)
{
  // Readers that look at the first word alone take a file that begins with "solid" for text.
  std::string bytes = (title.starts_with("solid") ? " " : "") + title;
  bytes.resize(80, '\0');
  bytes.reserve(84 + 50 * mesh.triangles.size());
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points.at(t[0]), &b = mesh.points.at(t[1]), &c = mesh.points.at(t[2]);
    const Vec3 area = cross(b - a, c - a);
    const double length = norm(area);
    append(bytes, length > 0.0 ? single((1.0 / length) * area) : Floats{});
    for (const Vec3& corner : {a, b, c}) append(bytes, single(corner));
    append(bytes, std::uint16_t{0});
  }
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw FileError(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
}

} // namespace towform
