#pragma once
#include "towform/vec3.hpp"
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace towform {

using Triangle = std::array<int, 3>; ///< node numbers, counter-clockwise seen against the normal

/// A triangulated surface: a tool, outward normals by the right-hand rule. Lengths in m.
struct SurfaceMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// Reads an STL file, ASCII or binary, whose lengths are multiples of `unit` metres; welds equal points,
/// and checks the facets. Facet normals of the file are ignored: orientation is the order of the corners.
/// Throws FileError: missing, empty, truncated, not STL, non-finite, degenerate facets, duplicate facets,
/// more than two facets on an edge, neighbours of opposite orientation; the message names the first facet
/// (counted from 1, as in the file) and how many there are.
SurfaceMesh read_stl(const std::filesystem::path& path, double unit = 1.0);

/// Writes a binary STL file, lengths in m; `title` goes into the 80-byte header. Throws FileError.
void write_stl(const std::filesystem::path& path, const SurfaceMesh& mesh, const std::string& title);

/// Joins points closer than `tolerance` [m] (by a grid, so in linear time); facets that collapse are dropped
/// only if `drop_collapsed`.
SurfaceMesh weld(const SurfaceMesh& mesh, double tolerance, bool drop_collapsed);

} // namespace towform
