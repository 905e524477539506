#pragma once
#include "contact/facet.hpp"
#include "contact/facet_tree.hpp"
#include "towform/surface_mesh.hpp"
#include <limits>
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
  /// The point of one facet nearest to p, with the side of the tool that p is on if no facet is nearer.
  [[nodiscard]] SurfacePoint at(const Vec3& p, int facet) const;
  [[nodiscard]] SurfacePoint at(const Vec3& p, int facet, const FacetPoint& nearest) const;
  /// The same where that point is known to be inside the facet.
  [[nodiscard]] SurfacePoint above(const Vec3& p, int facet) const;
  /// The nearest point of two facets, of equally near ones the lower number's.
  [[nodiscard]] SurfacePoint nearest_of(const Vec3& p, int facet, int other) const;
  /// The facet beyond edge k of a facet, or -1 where the surface ends.
  [[nodiscard]] int across(int facet, int k) const { return tree_.facet(facet).across[k]; }
  /// Whether that facet lies in the same plane, to the last bit: then the edge is none to who is near it.
  [[nodiscard]] bool goes_on(int facet, int k) const { return tree_.facet(facet).goes_on[k]; }

  [[nodiscard]] Vec3 lowest() const { return lowest_; }   ///< corner of the bounding box
  [[nodiscard]] Vec3 highest() const { return highest_; } ///< opposite corner

private:
  SurfaceMesh mesh_;
  FacetTree tree_;
  std::vector<std::array<Vec3, 3>> edge_normal_;
  std::vector<Vec3> corner_normal_; // of mesh points
  std::vector<char> border_corner_;
  Vec3 lowest_, highest_;
};

} // namespace towform
