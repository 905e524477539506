#pragma once
#include "towform/vec3.hpp"
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace towform {

/// The triangles and quadrilaterals of a Gmsh file and the nodes that they use, with the lines they stand on.
struct MshMesh {
  struct Node {
    Vec3 place; ///< [m]
    std::int64_t tag = 0;
    int line = 0;
  };
  struct Element {
    std::array<int, 4> nodes{}; ///< places in `nodes`, in the file's order; the last is -1 for a triangle
    std::int64_t tag = 0;
    int line = 0;

    [[nodiscard]] int corners() const { return nodes[3] < 0 ? 3 : 4; }
  };
  std::vector<Node> nodes; ///< in the file's order
  std::vector<Element> elements;
};

/// Reads a Gmsh file of format MSH 4.1, ASCII, whose lengths are multiples of `unit` metres. Points and lines
/// are passed over, and so are sections other than $Nodes and $Elements. Throws FileError (missing,
/// unreadable) and InputError, code `files`, with the line: another version, binary, truncated, counts that
/// the file does not bear out (checked before memory is taken), numbers that are none or not finite, tags
/// used twice or not at all, elements other than 3-node triangles and 4-node quadrilaterals.
MshMesh read_msh(const std::filesystem::path& path, double unit);

/// The same of a file's text; `name` for messages.
MshMesh parse_msh(std::string_view text, const std::string& name, double unit);

} // namespace towform
