#include "contact/level.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace towform {

namespace {

double squared_from_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 e = b - a;
  return norm_squared(p - (a + std::clamp(dot(p - a, e) / norm_squared(e), 0.0, 1.0) * e));
}

/// Of a facet and an edge of another that lies in its plane: they do not cross, so that one's corner is nearest.
double squared_from_edge(const Facet& f, const Vec3& a, const Vec3& b)
{
  double least = std::min(nearest_on_facet(f, a).distance_squared, nearest_on_facet(f, b).distance_squared);
  for (const Vec3& corner : f.corner) least = std::min(least, squared_from_segment(corner, a, b));
  return least;
}

/// Facets that a walk has met.
class Met {
public:
  explicit Met(std::size_t facets)
  {
    if (mark.size() < facets) mark.resize(facets, 0);
    ++walk;
  }
  void meet(int facet) { mark[static_cast<std::size_t>(facet)] = walk; }
  [[nodiscard]] bool has(int facet) const { return mark[static_cast<std::size_t>(facet)] == walk; }

private:
  static thread_local std::vector<std::int64_t> mark; // the walk that met a facet last
  static thread_local std::int64_t walk;
};
thread_local std::vector<std::int64_t> Met::mark;
thread_local std::int64_t Met::walk = 0;

} // namespace

double level_room(const ToolSurface& surface, int facet, double most)
{
  const Facet& f = surface.tree().facet(facet);
  if (!(f.goes_on[0] && f.goes_on[1] && f.goes_on[2])) return 0.0;
  double room_squared = most * most;
  Met met(surface.mesh().triangles.size());
  std::vector<int> open{facet};
  met.meet(facet);
  while (!open.empty()) {
    const int number = open.back();
    open.pop_back();
    const Facet& here = surface.tree().facet(number);
    for (std::size_t k = 0; k < 3; ++k) {
      if (here.goes_on[k] && met.has(here.across[k])) continue;
      const double squared = number == facet ? 0.0 : squared_from_edge(f, here.corner[k], here.corner[(k + 1) % 3]);
      if (!here.goes_on[k]) {
        room_squared = std::min(room_squared, squared);
      } else if (squared < room_squared) {
        met.meet(here.across[k]);
        open.push_back(here.across[k]);
      }
    }
  }
  return std::sqrt(room_squared);
}

} // namespace towform
