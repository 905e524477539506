#pragma once
#include "contact/tool_surface.hpp"
#include <array>
#include <atomic>
#include <cmath>
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
      : surface_(surface), radius_(radius), competitors_(surface.mesh().triangles.size()), all_(competitors_.size())
  {
  }
  ~FacetNeighbours();
  FacetNeighbours(const FacetNeighbours&) = delete;
  FacetNeighbours& operator=(const FacetNeighbours&) = delete;

  /// The nearest point and how far one may be from an anchor, as long as one stays in front of its facet's plane, while it
  /// stays inside the facet.
  struct Nearest {
    SurfacePoint point;
    double reach = 0.0; ///< [m]; 0 when it is on an edge or corner, or may become so at once, and behind the plane
    Vec3 anchor;        ///< from which the reach counts
    int rival = -1; ///< where it is on an edge, or about to be: the facet beyond
    double clear = 0.0; ///< with a rival: how far one may move while no facet is nearest but the point's own and it [m]
  };
  /// The tool's point nearest to p, of equally near facets the lowest number; the quicker, the nearer `from` is (a facet,
  /// or -1 for none known).
  [[nodiscard]] Nearest nearest(const Vec3& p, int from) const;
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
  /// Those that may be nearer to who is above a facet, no higher than that: of a smooth surface few or none.
  struct Competitors {
    std::vector<Neighbour> facets;
    double highest = 0.0; ///< [m]
    double level = 0.0;   ///< how far round the facet, too: its plane goes on there (level_room) [m]
  };
  /// How far one may move before something, and which way it recedes.
  struct Limit {
    double room;
    Vec3 away; ///< unit
  };
  /// What limits how far one may move; the first of them, should there be too many, and the nearest of all.
  struct Limits {
    Limit nearest{HUGE_VAL, {}};
    std::array<Limit, 32> seen;
    std::size_t count = 0;

    void clear()
    {
      count = 0;
      nearest = {HUGE_VAL, {}};
    }
    void see(double room, const Vec3& away)
    {
      if (count < seen.size()) seen[count++] = {room, away};
      if (room < nearest.room) nearest = {room, away};
    }
  };
  using All = std::vector<int>;
  template <class List>
  using Lists = std::vector<std::atomic<const List*>>;
  template <class List>
  const List& of(int facet, Lists<List>& lists) const;
  void find_level(int facet, std::vector<Vec3>& corners) const;
  [[nodiscard]] static bool competes(const Facet& other, const Facet& f, std::span<const Vec3> level, double highest);
  [[nodiscard]] Competitors competitors(int facet, double highest, double level, std::span<const Vec3> space, std::span<const int> some) const;
  void fill(int facet, Competitors& list) const;
  void fill(int facet, All& list) const;
  [[nodiscard]] int walk(const Vec3& p, int from) const;
  void see_margin(const Vec3& p, int facet, Limits& limits) const;
  [[nodiscard]] int edge_of(const Vec3& p, int facet, Feature feature) const;
  void set_rival(const Vec3& p, const FacetPoint& best, Nearest& found) const;
  void widen(const Vec3& p, double height, const Limits& limits, Nearest& found) const;
  [[nodiscard]] bool reach_above(const Vec3& p, int facet, double height, Limits& limits) const;

  const ToolSurface& surface_;
  double radius_;
  double highest_ = 2.0 / 3.0 * radius_; ///< above a facet, for whom its competitors are known at least
  mutable Lists<Competitors> competitors_;
  mutable Lists<All> all_; // of few facets
};

} // namespace towform
