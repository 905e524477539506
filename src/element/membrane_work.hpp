#pragma once
#include "element/membrane_lanes.hpp"
#include <array>
#include <span>

namespace towform {

/// What a thread needs to compute a block.
struct Workplace {
  BlockLanes lanes;
  StripLanes strips;
  MembraneBatch batch;
  std::array<Padded, 3 * ElementBlocks::capacity> position;
  std::array<Padded, 3 * ElementBlocks::capacity> force{}; ///< nothing, between two blocks

  /// Brings a block's nodes near.
  void take(std::span<const int> nodes, std::span<const Vec3> of_all)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i) position[i].set(of_all[nodes[i]]);
  }
  void give(const BlockSlots::Range& nodes, std::span<Vec3> block_force)
  {
    Vec3* to = block_force.data() + nodes.first;
    for (int i = 0; i < nodes.count; ++i) {
      to[i] = force[i].vec3();
      force[i] = {};
    }
  }
};

} // namespace towform
