#include "element/element_blocks.hpp"
#include <algorithm>
#include <stdexcept>
#include <utility>

namespace towform {

namespace {

/// Elements of a block's strips outside its own, in an order that `before` tells.
template <class Before>
std::vector<int> guests_of(const YarnStrips& strips, const ElementBlocks::Block& b, const Before& before)
{
  std::vector<int> guests;
  for (int i = b.first_strip; i < b.first_strip + b.strips; ++i)
    for (const YarnEntry entry : strips.entries_of(static_cast<std::size_t>(i)))
      if (const int e = entry / 2; e < b.first_element || e >= b.first_element + b.own) guests.push_back(e);
  std::sort(guests.begin(), guests.end(), before);
  guests.erase(std::unique(guests.begin(), guests.end()), guests.end());
  return guests;
}

/// Strips from `first` on whose first entries belong to elements before `end`.
int strips_before(const YarnStrips& strips, int first, int end)
{
  int last = first;
  while (last < static_cast<int>(strips.size()) &&
         strips.entry[static_cast<std::size_t>(strips.first[static_cast<std::size_t>(last)])] / 2 < end)
    ++last;
  return last - first;
}

} // namespace

ElementBlocks::ElementBlocks(std::span<const Triangle> triangles, std::span<const int> shape, std::size_t nodes,
                             std::span<const int> tiles, YarnStrips& strips)
{
  const int elements = static_cast<int>(triangles.size());
  entry.resize(strips.entry.size());
  const auto before = [&](int e, int f) { return std::pair(shape[e], e) < std::pair(shape[f], f); };
  Block b;
  while (b.first_element < elements) {
    const auto next = std::upper_bound(tiles.begin(), tiles.end(), b.first_element);
    b.own = std::min(own_most, (next == tiles.end() ? elements : *next) - b.first_element);
    std::vector<int> guests;
    while (true) {
      b.strips = strips_before(strips, b.first_strip, b.first_element + b.own);
      guests = guests_of(strips, b, before);
      if (b.own + static_cast<int>(guests.size()) <= capacity) break;
      if (b.own == 1) throw std::length_error("the strips of yarn through one element have too many elements");
      b.own /= 2;
    }
    strips.sort_by_length(b.first_strip, b.strips);
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
    b.first_element += b.own;
    b.first_strip += b.strips;
  }
  slots.finish(nodes);
  element.shrink_to_fit();
  corner.shrink_to_fit();
  of_others.shrink_to_fit();
}

} // namespace towform
