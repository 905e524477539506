#pragma once
#include "contact/facet.hpp"
#include "towform/surface_mesh.hpp"
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

private:
  struct Boxes;
  [[nodiscard]] int depth() const;
  template <class Limit, class Visit>
  void walk(const Vec3& p, const Limit& limit, const Visit& visit) const;
  template <class Wanted>
  void find(const Wanted& wanted, std::vector<int>& found) const;
  std::unique_ptr<const Boxes> boxes_;
  std::vector<Facet> facets_;
};

} // namespace towform
