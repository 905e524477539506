#include "element/strip_parts.hpp"
#include <algorithm>
#include <array>

namespace towform {

namespace {

/// Gradients of an element's corners along warp and weft [1/m].
std::array<YarnPair, 3> corner_gradients(const YarnGradients& g)
{
  return {{{-g.warp_1 - g.warp_2, -g.weft_1 - g.weft_2}, {g.warp_1, g.weft_1}, {g.warp_2, g.weft_2}}};
}

std::vector<YarnGradients> gradients_of(const Membrane& membrane)
{
  std::vector<YarnGradients> of_element(membrane.triangles.size());
  for (int block = 0; block < membrane.blocks.count(); ++block)
    membrane.each_own(block, [&](std::size_t e, const FlatTriangle& flat) { of_element[e] = flat.gradients; });
  return of_element;
}

YarnStrips with_entries(YarnStrips strips)
{
  strips.find_entries();
  return strips;
}

} // namespace

StripParts::StripParts(std::span<const Triangle> triangles, std::span<const YarnGradients> gradients, std::span<const double> area,
                       const YarnStrips& strips)
{
  first_.push_back(0);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(parts_.size());
    for (const YarnEntry entry : strips.entries_of(i)) {
      const int e = entry / 2, family = entry % 2;
      const auto of_corner = corner_gradients(gradients[e]);
      const double weight = area[e] / strips.area[i];
      for (std::size_t c = 0; c < 3; ++c) {
        const int component = 2 * triangles[e][c] + family;
        const double gradient = weight * (family == 0 ? of_corner[c].warp : of_corner[c].weft);
        const auto same =
            std::find_if(parts_.begin() + begin, parts_.end(), [component](const Part& p) { return p.component == component; });
        if (same == parts_.end())
          parts_.push_back({component, gradient});
        else
          same->gradient += gradient;
      }
    }
    first_.push_back(static_cast<int>(parts_.size()));
  }
}

StripParts::StripParts(const Membrane& membrane)
    : StripParts(membrane.triangles, gradients_of(membrane), membrane.areas(), with_entries(membrane.strips))
{
}

} // namespace towform
