#pragma once
#include <filesystem>
#include <string>

namespace towform {

/// All bytes of a mesh file; `kind` names it in messages ("an STL file"). Throws FileError: missing, a
/// directory, not a regular file, unreadable, empty.
std::string read_mesh_file(const std::filesystem::path& path, const std::string& kind);

/// Throws InputError, code `files`: what is wrong on a line of a text file.
[[noreturn]] void refuse_line(const std::string& file, int line, const std::string& message);

} // namespace towform
