#pragma once
#include "towform/vec3.hpp"
#include <algorithm>
#include <span>

namespace towform {

/// The smallest box, sides along the axes, that holds some points [m].
struct Box {
  Vec3 low, high;
};

/// Of at least one point.
inline Box box_of(std::span<const Vec3> points)
{
  Box box{points.front(), points.front()};
  for (const Vec3& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

} // namespace towform
