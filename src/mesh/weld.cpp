#include "towform/surface_mesh.hpp"
#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

namespace towform {
namespace {

/// Points hashed by the cell of a grid they lie in; chains may mix cells, which only costs a comparison.
class PointGrid {
public:
  PointGrid(const std::vector<Vec3>& points, double tolerance) : tolerance_(tolerance), low_(points.front())
  {
    Vec3 high = low_;
    for (const Vec3& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    // Cells of several tolerances: most searches then look into one cell only. The floor keeps cell numbers
    // well inside 64 bits when the tolerance is zero or tiny.
    cell_ = std::max({8.0 * tolerance, 1e-9 * norm(high - low_), 1e-300});
    heads_.assign(std::bit_ceil(points.size()), -1);
  }

  /// The number of the closest kept point within the tolerance, or -1.
  [[nodiscard]] int find(const Vec3& p) const
  {
    int found = -1;
    double nearest = tolerance_ * tolerance_;
    const Cell a = cell(p - Vec3{tolerance_, tolerance_, tolerance_});
    const Cell b = cell(p + Vec3{tolerance_, tolerance_, tolerance_});
    for (std::int64_t z = a.z; z <= b.z; ++z)
      for (std::int64_t y = a.y; y <= b.y; ++y)
        for (std::int64_t x = a.x; x <= b.x; ++x)
          for (int k = heads_[bucket({x, y, z})]; k >= 0; k = next_[k]) {
            const double d = norm_squared(kept_[k] - p);
            if (d < nearest || (d == nearest && (found < 0 || k < found))) {
              nearest = d;
              found = k;
            }
          }
    return found;
  }

  int keep(const Vec3& p)
  {
    const int k = static_cast<int>(kept_.size());
    int& head = heads_[bucket(cell(p))];
    kept_.push_back(p);
    next_.push_back(head);
    return head = k;
  }

  std::vector<Vec3> take() { return std::move(kept_); }

private:
  struct Cell {
    std::int64_t x, y, z;
  };
  [[nodiscard]] Cell cell(const Vec3& p) const
  {
    const auto along = [this](double d) { return static_cast<std::int64_t>(std::floor(d / cell_)); };
    return {along(p.x - low_.x), along(p.y - low_.y), along(p.z - low_.z)};
  }
  [[nodiscard]] std::size_t bucket(const Cell& c) const
  {
    std::uint64_t h = 0;
    for (const std::int64_t k : {c.x, c.y, c.z}) {
      h = (h ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15u; // odd, bits well mixed
      h ^= h >> 32;
    }
    return h & (heads_.size() - 1);
  }

  double tolerance_, cell_ = 0.0;
  Vec3 low_;
  std::vector<Vec3> kept_;
  std::vector<int> heads_, next_;
};

} // namespace

SurfaceMesh weld(const SurfaceMesh& mesh, double tolerance, bool drop_collapsed)
{
  assert(tolerance >= 0.0);
  if (mesh.points.empty()) return mesh;
  PointGrid grid(mesh.points, tolerance);
  std::vector<int> joined;
  joined.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) {
    const int found = grid.find(p);
    joined.push_back(found >= 0 ? found : grid.keep(p));
  }
  SurfaceMesh result{grid.take(), {}};
  result.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Triangle r{joined[t[0]], joined[t[1]], joined[t[2]]};
    const bool collapsed = r[0] == r[1] || r[1] == r[2] || r[2] == r[0];
    if (!(collapsed && drop_collapsed)) result.triangles.push_back(r);
  }
  return result;
}

} // namespace towform
