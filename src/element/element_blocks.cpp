#include "element/element_blocks.hpp"
#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace towform {

namespace {

/// Elements that blocks begin with: at tiles, and with as many elements as a block may own.
std::vector<int> begins_of_blocks(int elements, std::span<const int> tiles)
{
  std::vector<int> begins;
  for (int at = 0; at < elements;) {
    begins.push_back(at);
    const auto next = std::upper_bound(tiles.begin(), tiles.end(), at);
    at = std::min(at + ElementBlocks::own_most, next == tiles.end() ? elements : *next);
  }
  return begins;
}

/// Which block has a strip: that of most of its elements, of equals the first. The others of its elements are guests there.
class Owners {
public:
  /// Blocks begin with the elements `begins`.
  Owners(const YarnStrips& strips, std::span<const int> begins, int elements)
      : guests(begins.size()), begins_(begins), elements_(elements)
  {
    for (std::size_t i = 0; i < strips.size(); ++i) {
      const std::span<const YarnEntry> entries = strips.entries_of(i);
      const int owner = most_common_block(entries);
      of_strip.push_back(owner);
      for (const YarnEntry entry : entries)
        if (block_of(entry / 2) != owner) guests[owner].push_back(entry / 2);
    }
    for (std::vector<int>& its : guests) {
      std::sort(its.begin(), its.end());
      its.erase(std::unique(its.begin(), its.end()), its.end());
    }
  }

  /// How many elements a block has.
  [[nodiscard]] int own(std::size_t block) const
  {
    return (block + 1 < begins_.size() ? begins_[block + 1] : elements_) - begins_[block];
  }

  std::vector<int> of_strip;
  std::vector<std::vector<int>> guests; ///< of each block, ascending

private:
  [[nodiscard]] int block_of(int element) const
  {
    return static_cast<int>(std::upper_bound(begins_.begin(), begins_.end(), element) - begins_.begin()) - 1;
  }
  /// Of entries that ascend.
  [[nodiscard]] int most_common_block(std::span<const YarnEntry> entries) const
  {
    int best = -1;
    std::ptrdiff_t most = 0;
    for (auto entry = entries.begin(); entry != entries.end();) {
      const int block = block_of(*entry / 2);
      const auto next = std::find_if(entry, entries.end(), [&](YarnEntry other) { return block_of(other / 2) != block; });
      if (next - entry > most) {
        most = next - entry;
        best = block;
      }
      entry = next;
    }
    return best;
  }

  std::span<const int> begins_;
  int elements_;
};

/// Halves the blocks that have more places than they may; returns whether there were any.
bool halve_full(const Owners& owners, std::vector<int>& begins)
{
  std::vector<int> middles;
  for (std::size_t block = 0; block < begins.size(); ++block) {
    const int own = owners.own(block);
    if (own + static_cast<int>(owners.guests[block].size()) <= ElementBlocks::capacity) continue;
    if (own == 1) throw std::length_error("the strips of yarn through one element have too many elements");
    middles.push_back(begins[block] + own / 2);
  }
  begins.insert(begins.end(), middles.begin(), middles.end());
  std::sort(begins.begin(), begins.end());
  return !middles.empty();
}

/// Strips by their blocks, and there by length: loops over their entries then end as the processor expects.
std::vector<int> order_of(const YarnStrips& strips, const Owners& owners)
{
  std::vector<int> order(strips.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rank = [&](int strip) { return std::tuple(owners.of_strip[strip], strips.entries_of(strip).size(), strip); };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return rank(i) < rank(j); });
  return order;
}

} // namespace

ElementBlocks::ElementBlocks(std::span<const Triangle> triangles, std::span<const int> shape, std::size_t nodes,
                             std::span<const int> tiles, YarnStrips& strips)
{
  const int elements = static_cast<int>(triangles.size());
  entry.resize(strips.entry.size());
  const auto before = [&](int e, int f) { return std::pair(shape[e], e) < std::pair(shape[f], f); };
  std::vector<int> begins = begins_of_blocks(elements, tiles);
  std::optional<Owners> owners;
  do owners.emplace(strips, begins, elements);
  while (halve_full(*owners, begins));
  const std::vector<int> order = order_of(strips, *owners);
  strips.reorder(order);
  Block b;
  for (std::size_t number = 0; number < begins.size(); ++number) {
    const auto is_other = [&](int strip) { return owners->of_strip[strip] != static_cast<int>(number); };
    std::vector<int>& guests = owners->guests[number];
    std::sort(guests.begin(), guests.end(), before);
    b.first_element = begins[number];
    b.own = owners->own(number);
    b.strips = static_cast<int>(std::find_if(order.begin() + b.first_strip, order.end(), is_other) - order.begin()) - b.first_strip;
    b.places = b.own + static_cast<int>(guests.size());
    b.first_place = static_cast<int>(element.size());
    for (int e = b.first_element; e < b.first_element + b.own; ++e) element.push_back(e);
    element.insert(element.end(), guests.begin(), guests.end());

    const std::span<const int> mine = std::span<const int>(element).subspan(static_cast<std::size_t>(b.first_place));
    std::vector<int> its_nodes;
    for (const int e : mine) its_nodes.insert(its_nodes.end(), triangles[e].begin(), triangles[e].end());
    b.nodes = slots.add(std::move(its_nodes));
    for (const int e : mine)
      for (const int n : triangles[e]) corner.push_back(slots.local(b.nodes, n));

    for (int i = b.first_strip; i < b.first_strip + b.strips; ++i)
      for (int k = strips.first[i]; k < strips.first[i + 1]; ++k) {
        const int e = strips.entry[k] / 2, family = strips.entry[k] % 2;
        const int own_place = e - b.first_element;
        const auto place = own_place >= 0 && own_place < b.own
                               ? own_place
                               : b.own + (std::lower_bound(guests.begin(), guests.end(), e, before) - guests.begin());
        entry[k] = static_cast<Entry>(place + stride * family);
      }
    b.first_of_others = static_cast<int>(of_others.size());
    for (int place = 0; place < b.places; ++place)
      for (int family = 0; family < 2; ++family) {
        const int strip = strips.of[static_cast<std::size_t>(2 * mine[static_cast<std::size_t>(place)] + family)];
        if (strip < b.first_strip || strip >= b.first_strip + b.strips)
          of_others.push_back(static_cast<Entry>(place + stride * family));
      }
    b.of_others = static_cast<int>(of_others.size()) - b.first_of_others;
    blocks.push_back(b);
    b.first_strip += b.strips;
  }
  slots.finish(nodes);
  element.shrink_to_fit();
  corner.shrink_to_fit();
  of_others.shrink_to_fit();
}

} // namespace towform
