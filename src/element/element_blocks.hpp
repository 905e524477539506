#pragma once
#include "element/block_slots.hpp"
#include "element/yarn_strips.hpp"
#include "towform/surface_mesh.hpp"
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// The elements of a blank in blocks that one thread computes at a time, from a cache's worth of data: a run of
/// consecutive elements ("own"), the strips of yarn that have most of their elements among them, and, where such a strip
/// goes on beyond the run, its elements there ("guests", whose yarns alone are of interest). Forces are
/// summed by block (BlockSlots).
struct ElementBlocks {
  static constexpr int own_most = 1800; ///< elements of a block
  static constexpr int capacity = 2304; ///< places of a block, for own elements and guests
  static constexpr int stride = capacity + 24; ///< from warp to weft: arrays that far apart do not share a cache's sets

  /// Numbers of what belongs to a block in the arrays below.
  struct Block {
    int first_element = 0, own = 0; ///< elements
    int places = 0;                 ///< own elements, then guests shape by shape
    int first_place = 0;            ///< in `element`; in `corner` times 3
    int first_strip = 0, strips = 0;
    int first_of_others = 0, of_others = 0; ///< entries whose strips belong to other blocks
    BlockSlots::Range nodes;
  };
  /// An entry of a strip by its place in the block: place + stride * family (0 warp, 1 weft).
  using Entry = std::uint16_t;

  std::vector<Block> blocks;
  std::vector<int> element;          ///< of each place; needed to lay out what belongs to places, and may be let go then
  std::vector<std::uint16_t> corner; ///< of each place three, counted within the block's nodes
  std::vector<Entry> entry;          ///< of all strips, in the order of YarnStrips::entry
  std::vector<Entry> of_others;      ///< entries of the blocks' places whose strips are other blocks'
  BlockSlots slots;                  ///< of nodes, for forces

  ElementBlocks() = default;
  /// Blocks end where `tiles` do (first elements, ascending), and within them where they must. `shape` of each element
  /// (element_shapes). Strips come into the order of their blocks. Throws
  /// std::length_error when a single element's strips have more elements than a block has places.
  ElementBlocks(std::span<const Triangle> triangles, std::span<const int> shape, std::size_t nodes, std::span<const int> tiles,
                YarnStrips& strips);

  /// Corners of a block's places, three each.
  [[nodiscard]] const std::uint16_t* corners(const Block& b) const
  {
    return corner.data() + 3 * static_cast<std::ptrdiff_t>(b.first_place);
  }
  [[nodiscard]] std::span<const Entry> entries_of_others(const Block& b) const
  {
    return {of_others.data() + b.first_of_others, static_cast<std::size_t>(b.of_others)};
  }
  [[nodiscard]] int count() const { return static_cast<int>(blocks.size()); }
};

} // namespace towform
