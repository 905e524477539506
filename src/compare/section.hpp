#pragma once
#include "towform/surface_mesh.hpp"
#include <optional>
#include <span>
#include <vector>

namespace towform {

/// A part of a section that lies in one triangle.
struct SectionPiece {
  int element = 0;
  Vec3 from, to;         ///< its ends [m]
  double along_from = 0; ///< of its ends in plan, from the section's start [m]
  double along_to = 0;
  double arc_from = 0; ///< length of the section up to its ends, over the surface [m]
  double arc_to = 0;
};

/// The line in which the upright plane through two plan points cuts a sheet, from the first to the second.
/// Where the sheet has a gap the length goes on straight across it. A section that starts outside the sheet
/// begins at its edge. Where the plane runs along the edges of triangles it has the triangles of one side;
/// `left` says which, and where that side has none, nothing.
std::vector<SectionPiece> cut_section(std::span<const Vec3> places, std::span<const Triangle> triangles,
                                      Vec2 from, Vec2 to, bool left);

} // namespace towform
