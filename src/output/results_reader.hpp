#pragma once
#include "towform/surface_mesh.hpp"
#include <filesystem>
#include <optional>
#include <vector>

namespace towform {

/// The sheet of a results file at one of its frames. n nodes, m elements.
struct SheetResult {
  SurfaceMesh flat;           ///< the reference: n places [m], m triangles
  std::vector<Vec3> position; ///< n [m]
  std::vector<double> shear;  ///< m [deg]
  double time = 0.0;          ///< [s]
  int frame = 0, frames = 0;  ///< its number, from 0, and how many the file holds
};

/// Reads a frame, the last one unless its number is given. Throws FileError naming the file: not there, not
/// results, no such frame, arrays whose sizes or units are not those of results, values that are not finite.
SheetResult read_sheet(const std::filesystem::path& path, std::optional<int> frame);

} // namespace towform
