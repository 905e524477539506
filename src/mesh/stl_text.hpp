#pragma once
#include "towform/surface_mesh.hpp"
#include <string>
#include <string_view>

namespace towform {

/// Reads the text of an ASCII STL file: three points a facet, not welded, in the file's unit. One or more
/// solids; keywords in any case. Throws FileError `name:line: …`.
SurfaceMesh parse_stl_text(std::string_view text, const std::string& name);

} // namespace towform
