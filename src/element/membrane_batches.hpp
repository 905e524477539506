#pragma once
#include "element/membrane_lanes.hpp"
#include <span>
#include <vector>

namespace towform {

/// Yarn vectors of a triangle are weighted sums of its edges from corner 0:
/// F f01 = warp_1 (x1 - x0) + warp_2 (x2 - x0), likewise weft, with warp_k = grad N_k . f01 [1/m].
struct YarnGradients {
  double warp_1, warp_2, weft_1, weft_2;
};

/// A triangle of the flat blank.
struct FlatTriangle {
  YarnGradients gradients;
  double area; ///< [m^2]
};

/// The places of every block in batches that go through the work together, and what their elements are made of. Elements of
/// one shape share that: of a regular mesh it takes no memory, and is always near.
class MembraneBatches {
public:
  struct Batch {
    int first, count; ///< places of the block
    int coefficients; ///< where they begin
    int stride;       ///< from one coefficient to the next
  };

  MembraneBatches() = default;
  /// Of elements of these `shape`s (element_shapes).
  MembraneBatches(const ElementBlocks& blocks, std::span<const int> shape, std::span<const FlatTriangle> elements);

  /// Of a block's own elements, of its guests, and of both.
  [[nodiscard]] std::span<const Batch> own(int block) const { return part(2 * block, 2 * block + 1); }
  [[nodiscard]] std::span<const Batch> guests(int block) const { return part(2 * block + 1, 2 * block + 2); }
  [[nodiscard]] std::span<const Batch> all(int block) const { return part(2 * block, 2 * block + 2); }

  [[nodiscard]] MembraneCoefficients coefficients(const Batch& b) const
  {
    const double* c = coefficients_.data() + b.coefficients;
    return {c, c + b.stride, c + 2 * b.stride, c + 3 * b.stride, c + 4 * b.stride};
  }

private:
  [[nodiscard]] std::span<const Batch> part(int begin, int end) const
  {
    return {batches_.data() + first_[begin], batches_.data() + first_[end]};
  }
  class Maker;

  std::vector<Batch> batches_;
  std::vector<int> first_; // of each block's own, its guests, and one more
  std::vector<double> coefficients_;
};

} // namespace towform
