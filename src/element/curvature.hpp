#pragma once
#include "element/block_slots.hpp"
#include "element/curvature_patch.hpp"
#include "element/mirrored_sheet.hpp"
#include "element/stencil_runs.hpp"
#include "towform/blank.hpp"
#include "towform/state.hpp"
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace towform {

/// Curvature of the sheet along its yarns at every node, kappa_i = n . x,ii [1/m]: x,ii is the second
/// derivative of the surface along reference direction f0i, a sum of c_k^i x_k over a patch of nodes with
/// constant weights, n the unit normal. Positive where the sheet curls towards its upper face (+z when flat).
/// Exact where positions are quadratic over the flat blank, whatever the mesh. Yarns being nearly
/// inextensible, this is the curvature of the yarn itself; its bending in the sheet's plane is left out.
struct CurvatureOperator {
  /// Nodes of a block whose patches are alike, in consecutive lanes (element/stencil_runs.hpp).
  struct Run {
    int first_lane = 0, count = 0;
    int first_place = 0;
    int first_term = 0;                                   ///< in `term`: of the warp, the weft and the change
    int warp_terms = 0, weft_terms = 0, change_terms = 0; ///< none of the change where all are alike
    int first_point = 0, points = 0;                      ///< in `run_point`
    int first_time = 0;                                   ///< in `times`
    std::array<int, 4> ends{};                            ///< of the chords, as lanes ahead
  };
  /// Nodes that one thread computes at a time, and the points of their patches: nodes, and beyond these images. Points are
  /// counted within the block. Runs come first, then the other nodes one by one.
  struct Block {
    int first_place = 0, places = 0;
    int first_run = 0, runs = 0;
    int first_single = 0, singles = 0;
    int lanes = 0;                    ///< none without runs
    int first_shared = 0, shared = 0; ///< points of single nodes, where there are lanes too
    BlockSlots::Range points;
  };
  static constexpr int most_nodes = 512; ///< of a block
  std::vector<Block> blocks;
  BlockSlots slots;
  std::vector<MirrorImage> images;

  /// Which node a place is for: nodes in the order in which they are computed, and lanes between those of runs, -1.
  std::vector<int> node;
  std::vector<std::uint16_t> lane;        ///< of each slot, in blocks with runs
  std::vector<std::uint16_t> shared_lane; ///< of points of single nodes, in blocks with runs
  std::vector<Run> runs;
  // Terms of runs (StencilRun):
  std::vector<StencilPoint> run_point;
  std::vector<StencilTerm> term; ///< what is not 0 of them, sum after sum
  std::vector<YarnPair> times;

  // Terms of single nodes: points' shares in the second derivatives there.
  std::vector<int> first;           ///< of each node's terms, and one more
  std::vector<std::uint16_t> point; ///< of each term: slot, or place among the block's shared points where it has runs
  std::vector<int> weights_of;      ///< where a node's weights begin: patches that differ by rounding alone share them
  std::vector<YarnPair> weight;     ///< c_k^1 and c_k^2 [1/m^2]
  /// The normal at a node lies along (x_1 - x_0) x (x_3 - x_2), two chords across its ring.
  std::vector<std::array<std::uint16_t, 4>> ends;
  double imbalance = 0.0; ///< of the moments, over that of the fits alone

  /// Weights along the blank's warp and weft. `balance` says how often moments are balanced
  /// (moment_balance.hpp): 0 will do to look at curvatures, forces need some. A blank that is too coarse for
  /// a quadratic leaves nodes without terms.
  CurvatureOperator(const Blank& blank, std::span<const SymmetryLine> clamped, int balance);

  [[nodiscard]] std::size_t nodes() const { return nodes_; }
  /// Has every node its terms?
  [[nodiscard]] bool complete() const;
  /// At every node, of a sheet at `position`.
  [[nodiscard]] std::vector<YarnPair> at(std::span<const Vec3> position) const;

  /// What a node's curvatures are made of, by points of the whole sheet.
  class Patch {
  public:
    std::array<int, 4> ends;
    /// work(point, weight) for every term.
    template <class Work>
    void each_term(const Work& work) const
    {
      for (std::size_t i = 0; i < point_.size(); ++i) work(point_[i], weight_[i]);
    }

  private:
    friend CurvatureOperator;
    std::vector<int> point_;
    std::vector<YarnPair> weight_;
  };
  /// work(place, patch) for the nodes of a block, in the order of places.
  template <class Work>
  void each_node(const Block& block, const Work& work) const
  {
    const std::vector<int> point_of_lane = points_by_lane(block);
    Patch patch;
    for (int r = block.first_run; r < block.first_run + block.runs; ++r)
      for (int i = 0; i < runs[r].count; ++i) {
        const int place = runs[r].first_place + i;
        if (node[place] < 0) continue;
        fill(patch, runs[r], i, point_of_lane);
        work(place, std::as_const(patch));
      }
    for (int i = 0; i < block.singles; ++i) {
      fill(patch, block, i, point_of_lane);
      work(block.first_place + block.places - block.singles + i, std::as_const(patch));
    }
  }

private:
  class SharedWeights;
  struct Laid;
  static Laid lay_out(std::span<const CurvaturePatch> patches, int first_node, std::span<const Vec3> flat);
  void add_block(std::span<const CurvaturePatch> patches, Laid laid, SharedWeights& shared);
  [[nodiscard]] std::vector<int> points_by_lane(const Block& block) const;
  void fill(Patch& patch, const Run& run, int number, std::span<const int> point_of_lane) const;
  void fill(Patch& patch, const Block& block, int single, std::span<const int> point_of_lane) const;
  std::size_t nodes_ = 0;
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
