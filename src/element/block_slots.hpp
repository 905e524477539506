#pragma once
#include "towform/vec3.hpp"
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// Where what blocks of a mesh add to the forces on points goes: a block has a slot for every point that it reaches. Of a point
/// that it alone reaches, its force is the point's; of others it has a place in an array, and the point's is the sum over its
/// places, in the order of the blocks. Blocks depend on the mesh alone, and so do all sums, whatever the number of threads.
class BlockSlots {
public:
  /// The slots of a block.
  struct Range {
    int first = 0, count = 0;
  };
  /// A block that reaches `points` (in any order, repeated or not).
  Range add(std::vector<int> points);
  /// To be called after the last block. Points from `always_summed` on have places even where one block reaches them.
  void finish(std::size_t always_summed);

  /// Places of forces that are to be summed.
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(first_of_.back()); }
  /// Points of a block's slots, ascending.
  [[nodiscard]] std::span<const int> points(const Range& block) const
  {
    return {point_.data() + block.first, static_cast<std::size_t>(block.count)};
  }
  /// Which of a block's slots a point has, counted within the block.
  [[nodiscard]] std::uint16_t local(const Range& block, int point) const;

  /// Where the forces of a block's slots (counted within the block) go.
  class Targets {
  public:
    Targets(const int* target, std::span<Vec3> of_point, std::span<Vec3> place) : target_(target), bases_{of_point.data(), place.data()} {}
    /// A point's own, or a place; without a branch, which would often be mispredicted.
    [[nodiscard]] Vec3& operator[](int slot) const
    {
      const int to = target_[slot];
      return bases_[to < 0 ? 1 : 0][to < 0 ? ~to : to];
    }

  private:
    const int* target_;
    std::array<Vec3*, 2> bases_;
  };
  [[nodiscard]] Targets targets(const Range& block, std::span<Vec3> of_point, std::span<Vec3> place) const
  {
    return {target_.data() + block.first, of_point, place};
  }
  [[nodiscard]] bool reaches_alone(const Range& block, int slot) const { return target_[block.first + slot] >= 0; }
  /// Points whose forces are sums, ascending.
  [[nodiscard]] std::span<const int> summed() const { return summed_; }
  /// The force on one of them, by its number among them.
  [[nodiscard]] Vec3 sum(std::span<const Vec3> place, std::ptrdiff_t number) const
  {
    Vec3 sum;
    for (int i = first_of_[number]; i < first_of_[number + 1]; ++i) sum += place[i];
    return sum;
  }

private:
  std::vector<int> point_;    // of each slot
  std::vector<int> target_;   // of each slot: its point where no other block reaches that, else ~place
  std::vector<int> summed_;   // points
  std::vector<int> first_of_; // of each of them its first place, and one more
};

} // namespace towform
