#pragma once
#include "contact/facet.hpp"
#include "towform/surface_mesh.hpp"
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

namespace towform {

/// A tree of axis-aligned boxes over the facets of a surface (FCL's), walked by our own traversal: FCL's
/// distance queries are slow against a single point and wrong where bodies overlap.
class FacetTree {
public:
  explicit FacetTree(const SurfaceMesh& mesh);
  ~FacetTree();
  FacetTree(FacetTree&&) noexcept;
  FacetTree& operator=(FacetTree&&) noexcept;

  /// The facet nearest to p within `bound` [m] (of equals, the lowest number), or -1.
  [[nodiscard]] int nearest(const Vec3& p, double bound) const;

  /// Roughly the nearest facet, quickly, and how near to p no facet is [m]: at least 0.7 of the true distance.
  struct Roughly {
    int facet;
    double no_nearer;
  };
  [[nodiscard]] Roughly roughly_nearest(const Vec3& p, double bound) const;

  /// Facets whose boxes overlap the box round some points grown by `distance` [m], in any order: put into `found`.
  void find_in_box_round(std::span<const Vec3> points, double distance, std::vector<int>& found) const;

  /// Of these only such as may be in front of a facet's plane.
  void find_in_front(const Facet& facet, std::span<const Vec3> points, double distance, std::vector<int>& found) const;

  [[nodiscard]] const Facet& facet(int number) const { return facets_[number]; }
  [[nodiscard]] Facet& facet(int number) { return facets_[number]; }
  /// Not more than the square of a facet's distance from p, quickly [m^2].
  [[nodiscard]] double least_distance_squared(const Vec3& p, int facet) const { return boxes_of_facets_[facet].distance_squared(p); }

private:
  /// A box in single precision, no smaller than the true one: half the cache.
  struct RoundedBox {
    std::array<float, 3> low, high;

    [[nodiscard]] double distance_squared(const Vec3& p) const
    {
      const auto outside = [](double x, double its_low, double its_high) { return std::max(std::max(its_low - x, x - its_high), 0.0); };
      const double dx = outside(p.x, low[0], high[0]), dy = outside(p.y, low[1], high[1]), dz = outside(p.z, low[2], high[2]);
      return dx * dx + dy * dy + dz * dz;
    }
  };
  struct Boxes;
  [[nodiscard]] int depth() const;
  template <class Limit, class Visit>
  void walk(const Vec3& p, const Limit& limit, const Visit& visit) const;
  template <class Wanted>
  void find(const Wanted& wanted, std::vector<int>& found) const;
  std::unique_ptr<const Boxes> boxes_;
  std::vector<Facet> facets_;
  std::vector<RoundedBox> boxes_of_facets_;
};

} // namespace towform
