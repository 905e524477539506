#pragma once
#include "element/mirrored_sheet.hpp"
#include <array>

namespace towform {

/// Two chords of a node's ring that pass as nearly through the node as can be and are not too nearly
/// parallel; of equally good ones those along and across the warp, so that a regular mesh is treated
/// regularly.
std::array<int, 4> chords_of(const MirroredSheet& sheet, int node, const Vec3& warp);

} // namespace towform
