#pragma once
#include "contact/near_facet.hpp"
#include "towform/surface_mesh.hpp"
#include <memory>
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

  /// All facets with a point within `radius` [m] of p, nearest first, replacing `found`.
  void within(const Vec3& p, double radius, std::vector<NearFacet>& found) const;

  [[nodiscard]] const std::array<Vec3, 3>& corners(int facet) const { return corners_[facet]; }

private:
  struct Boxes;
  [[nodiscard]] int depth() const;
  std::unique_ptr<const Boxes> boxes_;
  std::vector<std::array<Vec3, 3>> corners_;
};

} // namespace towform
