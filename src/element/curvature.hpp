#pragma once
#include "element/mirrored_sheet.hpp"
#include "towform/blank.hpp"
#include "towform/state.hpp"
#include <array>
#include <span>
#include <vector>

namespace towform {

/// Curvature of the sheet along its yarns at every node, kappa_i = n . x,ii [1/m]: x,ii is the second
/// derivative of the surface along reference direction f0i, a sum of c_k^i x_k over a patch of nodes with
/// constant weights, n the unit normal. Positive where the sheet curls towards its upper face (+z when flat).
/// Exact where positions are quadratic over the flat blank, whatever the mesh. Yarns being nearly
/// inextensible, this is the curvature of the yarn itself; its bending in the sheet's plane is left out.
struct CurvatureOperator {
  /// The normal at a node lies along (x_a1 - x_a0) x (x_b1 - x_b0), two chords across its ring.
  struct Chords {
    int a0, a1, b0, b1;
  };

  // Terms: points' shares in the second derivatives at a node, its own first.
  std::vector<int> first;       ///< n + 1, of each node's terms
  std::vector<int> point;       ///< of each term; points beyond the nodes are images
  std::vector<YarnPair> weight; ///< likewise, c_k^1 and c_k^2 [1/m^2]
  std::vector<Chords> chords;
  std::vector<MirrorImage> images;
  double imbalance = 0.0; ///< of the moments, over that of the fits alone

  /// Weights along the blank's warp and weft. `balance` says how often moments are balanced
  /// (moment_balance.hpp): 0 will do to look at curvatures, forces need some. A blank that is too coarse for
  /// a quadratic leaves nodes without terms.
  CurvatureOperator(const Blank& blank, std::span<const SymmetryLine> clamped, int balance);

  [[nodiscard]] std::size_t nodes() const { return chords.size(); }
  /// Has every node its terms?
  [[nodiscard]] bool complete() const;
  /// At every node, of a sheet at `position`.
  [[nodiscard]] std::vector<YarnPair> at(std::span<const Vec3> position) const;
};

/// Positions of nodes and images by number.
class ImagedPositions {
public:
  ImagedPositions(std::span<const Vec3> position, std::span<const Vec3> image)
      : position_(position), image_(image)
  {
  }
  const Vec3& operator[](int point) const
  {
    const auto p = static_cast<std::size_t>(point);
    return p < position_.size() ? position_[p] : image_[p - position_.size()];
  }

private:
  std::span<const Vec3> position_, image_;
};

} // namespace towform
