#pragma once
#include <filesystem>
#include <string>

namespace towform {

/// All bytes of a mesh file; `kind` names it in messages ("an STL file"). Throws FileError: missing, a
/// directory, not a regular file, unreadable, empty.
std::string read_mesh_file(const std::filesystem::path& path, const std::string& kind);

} // namespace towform
