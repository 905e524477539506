#include "solver/clearance.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace towform {

namespace {

/// Searches node after node, which are near each other: the tool and the facets found last come first.
class NearestTool {
public:
  NearestTool(const Model& model, const System& s) : model_(model), hint_(model.tools.size(), -1)
  {
    for (std::size_t i = 0; i < model.tools.size(); ++i)
      shift_.push_back(s.tools[i].displacement * model.tools[i].direction);
  }

  /// Signed distance from the nearest tool [m].
  double distance(const Vec3& x)
  {
    SurfacePoint best = from(last_, x, std::numeric_limits<double>::max());
    const std::size_t first = last_;
    for (std::size_t i = 0; i < shift_.size(); ++i) {
      if (i == first) continue;
      const SurfacePoint other = from(i, x, std::abs(best.distance));
      if (other.facet < 0) continue;
      const double more = std::abs(other.distance) - std::abs(best.distance);
      if (more > 0.0 || (more == 0.0 && other.distance >= best.distance)) continue;
      best = other;
      last_ = i;
    }
    return best.on_border ? std::abs(best.distance) : best.distance;
  }

private:
  SurfacePoint from(std::size_t tool, const Vec3& x, double bound)
  {
    const SurfacePoint found = model_.tools[tool].surface.nearest(x - shift_[tool], hint_[tool], bound);
    if (found.facet >= 0) hint_[tool] = found.facet;
    return found;
  }

  const Model& model_;
  std::vector<Vec3> shift_;
  std::vector<int> hint_;
  std::size_t last_ = 0;
};

} // namespace

std::vector<double> clearances(const Model& model, const System& s)
{
  if (model.tools.empty()) return {};
  std::vector<double> clearance(s.sheet.position.size());
  parallel_ranges(static_cast<std::ptrdiff_t>(clearance.size()), [&](auto begin, auto end) {
    NearestTool nearest(model, s);
    for (auto n = begin; n < end; ++n)
      clearance[n] = nearest.distance(s.sheet.position[n]) - 0.5 * model.membrane.thickness;
  });
  return clearance;
}

} // namespace towform
