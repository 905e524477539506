#include "element/block_slots.hpp"
#include <algorithm>

namespace towform {

BlockSlots::Range BlockSlots::add(std::vector<int> points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const Range range{static_cast<int>(point_.size()), static_cast<int>(points.size())};
  point_.insert(point_.end(), points.begin(), points.end());
  return range;
}

void BlockSlots::finish(std::size_t always_summed)
{
  point_.shrink_to_fit();
  const std::size_t points = point_.empty() ? 0 : static_cast<std::size_t>(*std::max_element(point_.begin(), point_.end())) + 1;
  std::vector<int> next(points, 0); // first how many slots a point has, then its next place
  for (const int p : point_) ++next[p];
  first_of_.push_back(0);
  for (std::size_t p = 0; p < points; ++p) {
    const int slots = next[p];
    next[p] = -1;
    if (slots == 0 || (slots == 1 && p < always_summed)) continue;
    next[p] = first_of_.back();
    summed_.push_back(static_cast<int>(p));
    first_of_.push_back(first_of_.back() + slots);
  }
  summed_.shrink_to_fit();
  first_of_.shrink_to_fit();
  target_.reserve(point_.size());
  for (const int p : point_) target_.push_back(next[p] < 0 ? p : ~next[p]++);
}

std::uint16_t BlockSlots::local(const Range& block, int point) const
{
  const auto its = points(block);
  return static_cast<std::uint16_t>(std::lower_bound(its.begin(), its.end(), point) - its.begin());
}

} // namespace towform
