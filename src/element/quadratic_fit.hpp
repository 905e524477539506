#pragma once
#include "element/mirrored_sheet.hpp"
#include <vector>

namespace towform {

/// First and second derivatives at a node of a field on the flat blank, as weights on the values at a patch
/// of points: those of the quadratic that fits the values best (least squares, nearer points counting more).
/// Exact for every quadratic.
struct QuadraticFit {
  struct Weights {
    double x, y;       ///< d/dx, d/dy [1/m]
    double xx, xy, yy; ///< d2/dx2, d2/dxdy, d2/dy2 [1/m^2]
  };
  std::vector<int> points;      ///< of the sheet with its images; the node comes first
  std::vector<Weights> weights; ///< one a point
  double radius = 0.0;          ///< of the patch [m]
};

/// Fits round a node. The patch is the ring of its neighbours where that is symmetric about the node, else
/// with as much of the second ring as makes nine points. No points when the whole sheet has too few.
QuadraticFit quadratic_fit(const MirroredSheet& sheet, int node);

} // namespace towform
