#include "solver/clearance.hpp"
#include "contact/contact_lanes.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace towform {

namespace {

/// Searches node after node: where contact knows no plane, from the facet that it has found last, or that of the node before, which is near.
class NearestTool {
public:
  NearestTool(const Model& model, const System& s) : model_(model), s_(s), hint_(model.tools.size(), -1) {}

  /// Signed distance of a node from the nearest tool [m].
  double distance(std::size_t node)
  {
    SurfacePoint best = from(last_, node, std::numeric_limits<double>::max());
    const std::size_t first = last_;
    for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
      if (i == first) continue;
      const SurfacePoint other = from(i, node, std::abs(best.distance));
      if (other.facet < 0) continue;
      const double more = std::abs(other.distance) - std::abs(best.distance);
      if (more > 0.0 || (more == 0.0 && other.distance >= best.distance)) continue;
      best = other;
      last_ = i;
    }
    return best.on_border ? std::abs(best.distance) : best.distance;
  }

private:
  SurfacePoint from(std::size_t contact, std::size_t node, double bound)
  {
    const ContactState& state = s_.contacts[contact];
    const int number = model_.contacts[contact].tool, met = state.planes.found[node].facet;
    const Tool& tool = model_.tools[number];
    const Vec3 x = s_.sheet.position[node] - s_.tools[number].displacement * tool.direction;
    SurfacePoint found;
    if (const auto distance = distance_from_plane(state.planes, node, x)) {
      found.facet = met;
      found.distance = *distance;
    } else {
      const double at_least = least_distance(model_.contacts[contact], state, node, x);
      if (at_least <= bound) found = tool.surface.nearest(x, nearer(tool, x, met, hint_[contact]), bound);
    }
    if (found.facet >= 0) hint_[contact] = found.facet;
    return found;
  }

  /// Of two facets, -1 for none, the one that is nearer.
  static int nearer(const Tool& tool, const Vec3& x, int a, int b)
  {
    if (a < 0 || b < 0 || a == b) return std::max(a, b);
    const auto squared = [&](int facet) { return nearest_on_facet(tool.surface.tree().facet(facet), x).distance_squared; };
    return squared(b) < squared(a) ? b : a;
  }

  const Model& model_;
  const System& s_;
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
      clearance[n] = nearest.distance(static_cast<std::size_t>(n)) - 0.5 * model.membrane.thickness;
  });
  return clearance;
}

} // namespace towform
