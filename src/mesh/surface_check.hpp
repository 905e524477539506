#pragma once
#include "towform/surface_mesh.hpp"
#include <optional>
#include <string>

namespace towform {

/// What makes a triangulated surface unfit as a tool. Open boundaries are no fault.
enum class SurfaceDefect {
  degenerate,  ///< repeated corners, or a height below 1e-6 of the longest edge: no normal
  duplicate,   ///< the same three points as an earlier facet, whatever their order
  crowded,     ///< an edge with more than two facets
  orientation, ///< an edge that both its facets run through in the same direction
};

/// The first kind of defect found, in the order of SurfaceDefect. Facets are numbered from 0.
struct SurfaceFault {
  SurfaceDefect defect = SurfaceDefect::degenerate;
  int facet = 0; ///< lowest number among the offending facets
  int other = 0; ///< duplicate: the earlier facet; orientation: the neighbour; else the same as `facet`
  int count = 0; ///< of facets (degenerate, duplicate) or of edges (crowded, orientation)
};

std::optional<SurfaceFault> check_surface(const SurfaceMesh& mesh);

/// One sentence for the user, facets counted from 1: what is wrong, how often, what to do.
std::string describe(const SurfaceFault& fault);

} // namespace towform
