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

void BlockSlots::finish(std::size_t points)
{
  point_.shrink_to_fit();
  first_of_.assign(points + 1, 0);
  for (const int p : point_) ++first_of_[static_cast<std::size_t>(p) + 1];
  for (std::size_t p = 0; p < points; ++p) first_of_[p + 1] += first_of_[p];
  std::vector<int> next(first_of_.begin(), first_of_.end() - 1);
  slot_of_.resize(point_.size());
  for (std::size_t i = 0; i < point_.size(); ++i) slot_of_[next[point_[i]]++] = static_cast<int>(i);
}

std::uint16_t BlockSlots::local(const Range& block, int point) const
{
  const auto its = points(block);
  return static_cast<std::uint16_t>(std::lower_bound(its.begin(), its.end(), point) - its.begin());
}

} // namespace towform
