#pragma once
#include <algorithm>
#include <utility>
#include <vector>

namespace towform {

/// Sorts by `key(item)`, a number from 0 to keys - 1 that few items share, and items of one key by `less`: where keys are the
/// points of a mesh, in linear time.
template <class Item, class Key, class Less>
void bucket_sort(std::vector<Item>& items, std::size_t keys, const Key& key, const Less& less)
{
  std::vector<std::size_t> next(keys + 1, 0);
  for (const Item& item : items) ++next[static_cast<std::size_t>(key(item)) + 1];
  for (std::size_t k = 0; k < keys; ++k) next[k + 1] += next[k];
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[next[static_cast<std::size_t>(key(item))]++] = item; // then next[k] is the end of k
  for (std::size_t k = 0, begin = 0; k < keys; begin = next[k++])
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin), sorted.begin() + static_cast<std::ptrdiff_t>(next[k]), less);
  items = std::move(sorted);
}

} // namespace towform
