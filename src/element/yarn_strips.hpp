#pragma once
#include "towform/blank.hpp"
#include <span>
#include <vector>

namespace towform {

/// A yarn family of an element: entry 2e is the warp of element e, entry 2e + 1 its weft.
using YarnEntry = int;

/// Strips of yarn over each of which the strain is taken as one: long along the yarn, where tension changes
/// slowly, and narrow across it, where neighbouring yarns slide freely past each other. A strip has
/// `strip_length` by `strip_width` of an element's edge, that is five or six triangles, laid out on the flat
/// blank in rows along the yarns from the middle of the blank, every other row shifted by half a length. The
/// displacements of the nodes are then about three times as many as the constraints that stiff yarns put on
/// them, and each row transports a motion along the yarn as it is, so that little locks whatever the mesh:
/// what is left falls with the edge (measured: docs/verification.md). Borders between zones of different
/// shear, which follow the yarns, blur over less than an edge.
///
/// Where the mesh follows the yarns, a row is the triangles on one side of a line of edges, and is divided evenly into strips of
/// `aligned_elements` or more (of twice as many on a line through the middle of the blank, whose two rows are mirror images).
/// The strip is a bar between two nodes of the line; that of the row on the other side begins elsewhere. The longer the
/// shortest strip, the longer is the stable step: 1.3 to 1.7 times that of strips in a lattice, six and a half edges long, which
/// cuts short ones. With 9 elements a double dome of 25,600 is 0.32 degrees RMS from the finest mesh, as with four (0.31), one of 3,200
/// 1.9. With 11 steps are 7 % longer still, for as good a shear (0.33), but strips reach into more blocks, and where a sheet folds
/// its quarter folds otherwise than the whole (0.2 degrees RMS apart). On meshes that cross the yarns longer strips lose shear
/// (hemisphere of 1,600 elements whose nodes are a fifth of an edge off: 1.2 degrees RMS from the mesh as it was with four edges,
/// 1.4 with six and a half).
///
/// Where triangles differ in size, strips follow them by factors of two. In a half or quarter model a strip
/// that reaches over the mirror plane holds the entries that stand for its other part, which are of the other
/// family when yarns lie at 45 degrees to the plane.
struct YarnStrips {
  static constexpr double strip_length = 4.0, strip_width = 0.7;
  static constexpr int aligned_elements = 9;
  static constexpr int fewest_entries = 3; ///< a strip of fewer elements joins its neighbour along the yarn

  std::vector<int> first;       ///< s + 1
  std::vector<YarnEntry> entry; ///< 2m, by strip, ascending in each; or none, which `of` tells as well
  std::vector<int> of;          ///< 2m, strip of every entry
  std::vector<double> area;     ///< s, sum over the entries [m^2]

  [[nodiscard]] std::size_t size() const { return area.size(); }
  [[nodiscard]] std::span<const YarnEntry> entries_of(std::size_t strip) const
  {
    return {entry.data() + first[strip], entry.data() + first[strip + 1]};
  }
  /// Makes `entry` from `of`.
  void find_entries();
  /// Puts the strips into another order: first comes number order[0].
  void reorder(std::span<const int> order);
};

/// Strips of a blank with elements of `area` [m^2].
YarnStrips lay_strips(const Blank& blank, std::span<const double> area);

/// A strip of its own for every entry: the plain constant-strain triangle.
YarnStrips strips_of_one(std::span<const double> area);

} // namespace towform
