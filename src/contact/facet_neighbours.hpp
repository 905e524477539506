#pragma once
#include "contact/tool_surface.hpp"
#include <atomic>
#include <optional>
#include <span>
#include <vector>

namespace towform {

/// Which facets of a tool lie within a distance of each other, so that who is near one of them needs no tree.
class FacetNeighbours {
public:
  /// Of the facets of `surface`, which must outlive this, those within `radius` [m] of each other, some farther ones
  /// too. A facet's list is made when it is first asked for, by whichever thread.
  FacetNeighbours(const ToolSurface& surface, double radius)
      : surface_(surface), radius_(radius), in_front_(surface.mesh().triangles.size()), all_(in_front_.size())
  {
  }
  ~FacetNeighbours();
  FacetNeighbours(const FacetNeighbours&) = delete;
  FacetNeighbours& operator=(const FacetNeighbours&) = delete;

  /// The nearest point and how far one may move from there, as long as one stays in front of its facet's plane, while it
  /// stays inside the facet.
  struct Nearest {
    SurfacePoint point;
    double reach = 0.0; ///< [m]; 0 when it is on an edge or corner, or may become so at once, and behind the plane
    int rival = -1; ///< where it is on an edge, or about to be: the facet beyond
    /// How far one may move while no facet is nearest but the point's own and its rival or, where there is none, those
    /// round it [m].
    double clear = 0.0;
  };
  /// The tool's point nearest to p, of equally near facets the lowest number; the quicker, the nearer `from` is (a facet,
  /// or -1 for none known).
  [[nodiscard]] Nearest nearest(const Vec3& p, int from) const;
  /// The same where p was found inside a facet and `clear` is left of what was said then; nothing where that is not known
  /// to be so still.
  [[nodiscard]] std::optional<Nearest> still_inside(const Vec3& p, int facet, double clear) const;
  /// Of a p that was in front of the tool, `beyond` at most past where it could not touch it [m]: how near no facet is, and
  /// one that is roughly the nearest. Nothing when p may be as near as the lists serve, or has come through the tool.
  struct Far {
    int facet;
    double distance; ///< that no facet is nearer than [m]
  };
  [[nodiscard]] std::optional<Far> far(const Vec3& p, int from, double beyond) const;
  /// Whether p, whose nearest point is inside a facet, is not about to leave its plane.
  [[nodiscard]] bool is_well_inside(const Vec3& p, int facet) const;

private:
  struct Neighbour {
    Vec3 normal; ///< its plane, here to be read in a row
    double offset;
    double over_turn; ///< 1/|normal - the facet's normal|; 0 where they are the same
    int facet;

    [[nodiscard]] double height(const Vec3& p) const { return dot(normal, p) - offset; }
  };
  /// Those of which some part is in front of a facet's plane.
  struct InFront {
    std::vector<Neighbour> facets;
    std::size_t round = 0; ///< so many, the first, lie round it: beyond the edges where another plane begins

    [[nodiscard]] std::span<const Neighbour> those_round() const { return std::span(facets).first(round); }
    [[nodiscard]] std::span<const Neighbour> others() const { return std::span(facets).subspan(round); }
  };
  using All = std::vector<int>;
  template <class List>
  using Lists = std::vector<std::atomic<const List*>>;
  template <class List>
  const List& of(int facet, Lists<List>& lists) const;
  void fill(int facet, InFront& list) const;
  void fill(int facet, All& list) const;
  [[nodiscard]] int walk(const Vec3& p, int from) const;
  [[nodiscard]] double margin(const Vec3& p, int facet) const;
  [[nodiscard]] int edge_of(const Vec3& p, int facet, Feature feature) const;
  void set_rival(const Vec3& p, const FacetPoint& best, Nearest& found) const;
  [[nodiscard]] bool lies_round(int facet, int other) const;
  [[nodiscard]] double reach_before(std::span<const Neighbour> others, const Vec3& p, double height, double most) const;

  const ToolSurface& surface_;
  double radius_;
  mutable Lists<InFront> in_front_;
  mutable Lists<All> all_; // of few facets
};

} // namespace towform
