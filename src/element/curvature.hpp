#pragma once
#include "element/block_slots.hpp"
#include "element/mirrored_sheet.hpp"
#include "towform/blank.hpp"
#include "towform/state.hpp"
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// Curvature of the sheet along its yarns at every node, kappa_i = n . x,ii [1/m]: x,ii is the second
/// derivative of the surface along reference direction f0i, a sum of c_k^i x_k over a patch of nodes with
/// constant weights, n the unit normal. Positive where the sheet curls towards its upper face (+z when flat).
/// Exact where positions are quadratic over the flat blank, whatever the mesh. Yarns being nearly
/// inextensible, this is the curvature of the yarn itself; its bending in the sheet's plane is left out.
struct CurvatureOperator {
  /// Nodes that one thread computes at a time, and the points of their patches: nodes, and beyond these images. Points are
  /// counted within the block.
  struct Block {
    int first_node = 0, nodes = 0;
    BlockSlots::Range points;
  };
  static constexpr int block_size = 128;
  std::vector<Block> blocks;
  BlockSlots slots;
  std::vector<MirrorImage> images;

  // Terms: points' shares in the second derivatives at a node.
  std::vector<int> first;           ///< n + 1, of each node's terms
  std::vector<std::uint16_t> point; ///< of each term
  std::vector<int> weights_of;      ///< n, where a node's weights begin: patches that differ by rounding alone share them
  std::vector<YarnPair> weight;     ///< c_k^1 and c_k^2 [1/m^2]
  /// n: the normal at a node lies along (x_1 - x_0) x (x_3 - x_2), two chords across its ring.
  std::vector<std::array<std::uint16_t, 4>> ends;
  double imbalance = 0.0; ///< of the moments, over that of the fits alone

  /// Weights along the blank's warp and weft. `balance` says how often moments are balanced
  /// (moment_balance.hpp): 0 will do to look at curvatures, forces need some. A blank that is too coarse for
  /// a quadratic leaves nodes without terms.
  CurvatureOperator(const Blank& blank, std::span<const SymmetryLine> clamped, int balance);

  [[nodiscard]] std::size_t nodes() const { return ends.size(); }
  /// work(point of the whole sheet, weight) for a node's terms.
  template <class Work>
  void each_term(std::size_t node, const Work& work) const
  {
    const std::span<const int> points = slots.points(blocks[node / block_size].points);
    const YarnPair* its = weight.data() + weights_of[node];
    for (int t = first[node]; t < first[node + 1]; ++t) work(points[point[t]], *its++);
  }
  /// Has every node its terms?
  [[nodiscard]] bool complete() const;
  /// At every node, of a sheet at `position`.
  [[nodiscard]] std::vector<YarnPair> at(std::span<const Vec3> position) const;

private:
  struct Patch;
  class SharedWeights;
  void add_block(std::span<const Patch> patches);
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
