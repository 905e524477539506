#pragma once
#include "towform/blank.hpp"
#include "towform/vec3.hpp"
#include <span>
#include <vector>

namespace towform {

/// A straight line of nodes, x = const or y = const on the flat blank, about which the sheet is symmetric: a
/// mirror plane of the blank, or an edge clamped in a grip, which the sheet meets without a slope. A grip may
/// move, but does not turn.
struct SymmetryLine {
  enum class Across { x, y };
  Across across = Across::x; ///< the coordinate that is constant along the line
  std::vector<int> nodes;
};

/// The image of a node behind one or two such lines. Where a line's coordinate is mirrored, a node on the
/// line tells where it is.
struct MirrorImage {
  int source = 0;               ///< node
  int line_x = -1, line_y = -1; ///< a node on the line; -1 where the coordinate is the source's own

  [[nodiscard]] Vec3 position(std::span<const Vec3> x) const
  {
    Vec3 p = x[source];
    if (line_x >= 0) p.x = 2.0 * x[line_x].x - p.x;
    if (line_y >= 0) p.y = 2.0 * x[line_y].y - p.y;
    return p;
  }
  /// A force on the image, given to the nodes that place it (the transpose of `position`).
  void hand_on(Vec3 f, std::span<Vec3> force) const
  {
    if (line_x >= 0) {
      force[line_x].x += 2.0 * f.x;
      f.x = -f.x;
    }
    if (line_y >= 0) {
      force[line_y].y += 2.0 * f.y;
      f.y = -f.y;
    }
    force[source] += f;
  }
};

/// The flat blank continued by its images behind its symmetry lines, two rings of nodes deep: what a patch
/// at such a line is cut from. Nodes 0 .. n-1 are the blank's, the rest its images.
struct MirroredSheet {
  std::vector<Vec3> points;                 ///< of nodes and images [m]
  std::vector<MirrorImage> images;          ///< of points n, n + 1, …
  std::vector<std::vector<int>> neighbours; ///< of every point, along edges, ascending
  std::size_t nodes = 0;                    ///< n

  MirroredSheet(const SurfaceMesh& flat, std::span<const SymmetryLine> lines);

  /// The node that a point is, or is the image of.
  [[nodiscard]] int source(int point) const
  {
    const auto p = static_cast<std::size_t>(point);
    return p < nodes ? point : images[p - nodes].source;
  }

private:
  void mirror(const SymmetryLine& line);
};

} // namespace towform
