#pragma once
#include "contact/facet.hpp"
#include "contact/facet_tree.hpp"
#include "contact/near_facet.hpp"
#include "towform/surface_mesh.hpp"
#include <limits>
#include <span>
#include <vector>

namespace towform {

/// The nearest point of a tool's surface and which side of it a point is on.
struct SurfacePoint {
  int facet = -1;
  Vec3 point;
  Vec3 normal;            ///< unit, away from the tool along the shortest way
  double distance = 0.0;  ///< signed, negative inside the tool [m]
  bool inside = false;    ///< of the facet, not on its edges: `distance` is the height over its plane
  bool on_border = false; ///< nearest to an edge that only one facet has (an open surface ends there)
};

/// A rigid surface in its own frame: facets, their tree, and the normals that decide on the side: of facets,
/// of edges (mean of both facets) and of corners (weighted by angle; Baerentzen and Aanaes 2005).
class ToolSurface {
public:
  explicit ToolSurface(SurfaceMesh mesh);

  [[nodiscard]] const SurfaceMesh& mesh() const { return mesh_; }
  [[nodiscard]] const FacetTree& tree() const { return tree_; }

  /// Nearest point among all facets; `hint` (a facet, or -1) only makes it faster. Without a facet when none
  /// is within `bound` [m].
  [[nodiscard]] SurfacePoint nearest(const Vec3& p, int hint = -1,
                                     double bound = std::numeric_limits<double>::max()) const;
  /// Nearest point among some facets (not empty) that come in the order of their distance from a point
  /// `moved` away from p; of equally near ones the lowest number, as in `nearest`.
  [[nodiscard]] SurfacePoint nearest_of(const Vec3& p, std::span<const NearFacet> facets, double moved) const;

  /// How far p may move, in any direction, while its nearest point stays inside the facet that `nearest` is
  /// inside of [m], as far as `facets` tell (see nearest_of); not positive when it may change at once. Facets
  /// behind its plane can come no nearer, those in front of it not before p is on the plane that halves
  /// the angle between both.
  [[nodiscard]] double plane_reach(const Vec3& p, const SurfacePoint& nearest, std::span<const NearFacet> facets,
                                   double moved) const;

  [[nodiscard]] Vec3 lowest() const { return lowest_; }   ///< corner of the bounding box
  [[nodiscard]] Vec3 highest() const { return highest_; } ///< opposite corner

private:
  [[nodiscard]] SurfacePoint with_side(const Vec3& p, int facet, const FacetPoint& nearest) const;

  SurfaceMesh mesh_;
  FacetTree tree_;
  std::vector<std::array<Vec3, 3>> edge_normal_;
  std::vector<std::array<bool, 3>> border_edge_;
  std::vector<Vec3> corner_normal_; // of mesh points
  std::vector<char> border_corner_;
  Vec3 lowest_, highest_;
};

} // namespace towform
