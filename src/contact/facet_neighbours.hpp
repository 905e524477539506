#pragma once
#include "contact/tool_surface.hpp"
#include <atomic>
#include <optional>
#include <vector>

namespace towform {

/// Which facets of a tool lie within a distance of each other, so that who is near one of them needs no tree.
class FacetNeighbours {
public:
  /// Of the facets of `surface`, which must outlive this, those within `radius` [m] of each other, some farther ones
  /// too. A facet's list is made when it is first asked for, by whichever thread.
  FacetNeighbours(const ToolSurface& surface, double radius)
      : surface_(surface), radius_(radius), lists_(surface.mesh().triangles.size())
  {
  }
  ~FacetNeighbours();
  FacetNeighbours(const FacetNeighbours&) = delete;
  FacetNeighbours& operator=(const FacetNeighbours&) = delete;

  /// The nearest point and how far one may move from there, in any direction, while it stays inside its facet.
  struct Nearest {
    SurfacePoint point;
    double reach = 0.0; ///< [m]; 0 when it is on an edge or corner, or may become so at once
  };
  /// The tool's point nearest to p, found from a facet not far away; of equally near facets the lowest number, as
  /// by a search of all. Nothing when p is too far from the tool for the lists, half the radius.
  [[nodiscard]] std::optional<Nearest> nearest(const Vec3& p, int from) const;

private:
  struct Neighbour {
    Vec3 normal; ///< its plane, here to be read in a row
    double offset;
    double over_turn; ///< 1/|normal - the facet's normal|; 0 where they are the same
    int facet;

    [[nodiscard]] double height(const Vec3& p) const { return dot(normal, p) - offset; }
  };
  struct List {
    std::vector<Neighbour> all;
    /// Those of which some part is in front of the facet's plane, and those of which some is behind.
    std::vector<Neighbour> in_front, behind;
  };
  [[nodiscard]] const List& of(int facet) const
  {
    const List* list = lists_[facet].load(std::memory_order_acquire);
    return list != nullptr ? *list : make(facet);
  }
  const List& make(int facet) const;
  [[nodiscard]] int walk(const Vec3& p, int from) const;
  [[nodiscard]] double margin(const Vec3& p, int facet) const;
  [[nodiscard]] double reach_inside(const Vec3& p, int facet, double height, double margin) const;

  const ToolSurface& surface_;
  double radius_;
  mutable std::vector<std::atomic<const List*>> lists_;
};

} // namespace towform
