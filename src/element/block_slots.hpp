#pragma once
#include "towform/vec3.hpp"
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// Places for what blocks of a mesh add to the forces on points, each block by itself: a block has a slot for every
/// point that it reaches, and a point's force is the sum over its slots, in the order of the blocks. Blocks depend on the
/// mesh alone, and so do all sums, whatever the number of threads.
class BlockSlots {
public:
  /// The slots of a block.
  struct Range {
    int first = 0, count = 0;
  };
  /// A block that reaches `points` (in any order, repeated or not).
  Range add(std::vector<int> points);
  /// To be called after the last block. `points` of the mesh.
  void finish(std::size_t points);

  [[nodiscard]] std::size_t count() const { return point_.size(); }
  /// Points of a block's slots, ascending.
  [[nodiscard]] std::span<const int> points(const Range& block) const
  {
    return {point_.data() + block.first, static_cast<std::size_t>(block.count)};
  }
  /// Which of a block's slots a point has, counted within the block.
  [[nodiscard]] std::uint16_t local(const Range& block, int point) const;
  /// Sum over a point's slots.
  [[nodiscard]] Vec3 sum(std::span<const Vec3> force, std::ptrdiff_t point) const
  {
    Vec3 sum;
    for (int i = first_of_[point]; i < first_of_[point + 1]; ++i) sum += force[slot_of_[i]];
    return sum;
  }

private:
  std::vector<int> point_;             // of each slot
  std::vector<int> first_of_, slot_of_; // slots of each point, ascending
};

} // namespace towform
