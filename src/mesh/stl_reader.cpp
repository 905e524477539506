#include "mesh/mesh_file.hpp"
#include "mesh/stl_text.hpp"
#include "mesh/surface_check.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <bit>
#include <climits>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>

namespace towform {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read and written as little-endian");

// Binary STL: 80 bytes of title, the count as uint32, then per facet 12 float32 and an unused uint16.
constexpr std::uint64_t header_size = 84, facet_size = 50;

// Relative to the bounding box's diagonal: a few roundings of single precision.
constexpr double weld_tolerance = 1e-6;

std::uint64_t claimed_facets(const std::string& bytes)
{
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_size - sizeof count, sizeof count);
  return count;
}

/// The size decides, not the first word: binary files may begin with "solid" too.
bool is_binary(const std::string& bytes)
{
  return bytes.size() >= header_size && bytes.size() == header_size + facet_size * claimed_facets(bytes);
}

bool looks_like_text(const std::string& bytes)
{
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || bytes.find('\0') != std::string::npos) return false;
  constexpr std::string_view word = "solid";
  return bytes.size() - begin >= word.size() &&
         std::equal(word.begin(), word.end(), bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                    [](char w, char c) { return w == (c | 0x20); }); // ASCII letters in any case
}

SurfaceMesh parse_binary(const std::string& bytes, const std::string& name)
{
  const std::uint64_t facets = claimed_facets(bytes);
  if (facets > INT_MAX / 3) {
    throw FileError(fmt::format("{}: {} facets are more than towform can number; coarsen it", name, facets));
  }
  SurfaceMesh mesh;
  mesh.points.reserve(3 * facets);
  mesh.triangles.reserve(facets);
  for (std::uint64_t f = 0; f < facets; ++f) {
    float corners[9];
    const std::uint64_t normal_size = 12;
    std::memcpy(corners, bytes.data() + header_size + facet_size * f + normal_size, sizeof corners);
    const int first = static_cast<int>(mesh.points.size());
    for (int k = 0; k < 9; k += 3) {
      mesh.points.push_back({corners[k], corners[k + 1], corners[k + 2]});
      if (!is_finite(mesh.points.back())) {
        throw FileError(fmt::format("{}: facet {} has a coordinate that is not finite; export the mesh again",
                                    name, f + 1));
      }
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

SurfaceMesh parse(const std::string& bytes, const std::string& name)
{
  if (is_binary(bytes)) return parse_binary(bytes, name);
  if (looks_like_text(bytes)) return parse_stl_text(bytes, name);
  if (bytes.size() < header_size) {
    throw FileError(
        fmt::format("{}: is not an STL file: {} bytes that do not begin with 'solid'", name, bytes.size()));
  }
  const std::uint64_t facets = claimed_facets(bytes), expected = header_size + facet_size * facets;
  throw FileError(
      fmt::format("{}: is truncated or not an STL file: its header claims {} facets, which take {} "
                  "bytes, but it has {}; export it again",
                  name, facets, expected, bytes.size()));
}

double diagonal(const std::vector<Vec3>& points)
{
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return norm(high - low);
}

} // namespace

SurfaceMesh read_stl(const std::filesystem::path& path, double unit)
{
  if (!(std::isfinite(unit) && unit > 0.0)) {
    throw std::invalid_argument(fmt::format("the unit of a mesh must be a positive length, not {} m", unit));
  }
  const std::string name = path.string();
  SurfaceMesh mesh = parse(read_mesh_file(path, "an STL file"), name);
  if (mesh.triangles.empty()) throw FileError(fmt::format("{}: has no facets; export the mesh again", name));
  for (Vec3& p : mesh.points) p *= unit;
  mesh = weld(mesh, weld_tolerance * diagonal(mesh.points), false);
  if (const auto fault = check_surface(mesh)) {
    throw FileError(fmt::format("{}: {}", name, describe(*fault)));
  }
  return mesh;
}

} // namespace towform
