#pragma once
#include "element/yarn_strips.hpp"
#include "towform/surface_mesh.hpp"
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// The elements of a blank in blocks that one thread computes at a time, from a cache's worth of data: a run of
/// consecutive elements ("own"), the strips of yarn that begin among them, and, where such a strip goes on
/// beyond the run, its elements there ("guests", whose yarns alone are of interest). What a block adds to the
/// forces on its nodes is summed by itself; a node's force is the sum over the blocks that it is a corner in,
/// in their order. Blocks depend on the mesh alone, and so do all sums, whatever the number of threads.
struct ElementBlocks {
  static constexpr int own_most = 256; ///< elements of a block
  static constexpr int capacity = 512; ///< places of a block, for own elements and guests

  /// Numbers of what belongs to a block in the arrays below.
  struct Block {
    int first_element = 0, own = 0; ///< elements
    int places = 0;                 ///< own elements, then guests in ascending order
    int first_place = 0;            ///< in `element`; in `corner` and `coefficient` times 3 and 5
    int first_strip = 0, strips = 0;
    int first_slot = 0, nodes = 0; ///< in `node`, and of its partial forces
  };
  /// An entry of a strip by its place in the block: place + capacity * family (0 warp, 1 weft).
  using Entry = std::uint16_t;

  std::vector<Block> blocks;
  std::vector<int> element;          ///< of each place
  std::vector<std::uint16_t> corner; ///< of each place three, counted within the block's nodes
  std::vector<Entry> entry;          ///< of all strips, in the order of YarnStrips::entry
  std::vector<int> node;             ///< of each slot, ascending in each block
  std::vector<int> first_slot_of;    ///< n + 1, of each node in `slot_of`
  std::vector<int> slot_of;          ///< slots of each node, ascending

  ElementBlocks() = default;
  /// Strips must be in the order of their first entries. Throws std::length_error when a single element's strips
  /// have more elements than a block has places.
  ElementBlocks(std::span<const Triangle> triangles, std::size_t nodes, const YarnStrips& strips);

  [[nodiscard]] int count() const { return static_cast<int>(blocks.size()); }
  [[nodiscard]] std::size_t slots() const { return node.size(); }
};

} // namespace towform
