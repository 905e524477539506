#include "element/chords.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

std::array<int, 4> chords_of(const MirroredSheet& sheet, int node, const Vec3& warp)
{
  std::vector<int> ends = sheet.neighbours[node];
  ends.push_back(node);
  struct Chord {
    int from, to;
    double off; ///< distance of the middle from the node, over half the length
    Vec3 along; ///< unit
  };
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 from = sheet.points[ends[i]] - sheet.points[node],
                 to = sheet.points[ends[j]] - sheet.points[node];
      const double length = norm(to - from);
      chords.push_back({ends[i], ends[j], norm(from + to) / length, (1.0 / length) * (to - from)});
    }
  const auto best = [&](const auto& angle) { // the nearest, then that of the largest sine or cosine
    constexpr double rounding = 1e-6;
    const Chord* found = nullptr;
    for (const Chord& c : chords) {
      constexpr double least = 0.5;
      if (angle(c) < least) continue;
      const auto is_better = [&](const Chord& than) {
        const double nearer = than.off - c.off;
        return nearer > rounding || (nearer > -rounding && angle(c) > angle(than) + rounding);
      };
      if (found == nullptr || is_better(*found)) found = &c;
    }
    return found;
  };
  const auto cosine = [&](const Chord& c) { return std::abs(dot(c.along, warp)); };
  const Chord* first = best(cosine);
  if (first == nullptr) first = &chords.front();
  const auto sine = [&](const Chord& c) { return std::abs(cross(first->along, c.along).z); };
  const Chord* second = best(sine);
  if (second == nullptr) // the tip of a sliver
    second = &*std::max_element(chords.begin(), chords.end(),
                                [&](const Chord& c, const Chord& d) { return sine(c) < sine(d); });
  if (cross(first->along, second->along).z > 0.0) return {first->from, first->to, second->from, second->to};
  return {first->from, first->to, second->to, second->from};
}

} // namespace towform
