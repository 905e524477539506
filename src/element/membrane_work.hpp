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
  /// Hands a block's forces on, to `of_all` where they are a node's only ones.
  void give(const BlockSlots& slots, const BlockSlots::Range& nodes, std::span<Vec3> block_force, std::span<Vec3> of_all)
  {
    const BlockSlots::Targets targets = slots.targets(nodes, of_all, block_force);
    for (int i = 0; i < nodes.count; ++i) {
      targets[i] = force[i].vec3();
      force[i] = {};
    }
  }
};

} // namespace towform
