#include "contact/plane_search.hpp"
#include "contact/contact_lanes.hpp"
#include <algorithm>
#include <cmath>
#include <optional>

namespace towform {

namespace {

struct Search {
  const Contact& contact;
  const Tool& tool;
  ContactPlanes& planes;
};

/// How far a point's place as single precision tells it may be from the true one, and more.
double rounding(const Vec3& p) { return 4e-7 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)); }

/// A reach as single precision tells it, from an anchor that is rounded too; -1 for none.
float told(double reach, const Vec3& anchor)
{
  const double sure = reach - rounding(anchor);
  return sure > 0.0 ? static_cast<float>(sure * (1.0 - 1e-6)) : -1.0F;
}

void set_anchor(ContactPlanes& planes, int node, const Vec3& p)
{
  planes.anchor_x[node] = static_cast<float>(p.x);
  planes.anchor_y[node] = static_cast<float>(p.y);
  planes.anchor_z[node] = static_cast<float>(p.z);
}

double from_anchor(const ContactPlanes& planes, int node, const Vec3& p)
{
  return norm(p - Vec3{planes.anchor_x[node], planes.anchor_y[node], planes.anchor_z[node]});
}

/// The nearest point where a node is still nearest to the edge that it was found at.
std::optional<FacetNeighbours::Nearest> where_it_was(const Search& m, const Vec3& p, int node)
{
  ContactPlanes& planes = m.planes;
  FoundLast& last = planes.found[node];
  if (!(last.clear > 0.0F)) return {};
  const double left = last.clear - from_anchor(planes, node, p) - rounding(p);
  if (left <= 0.0) return {};
  const SurfacePoint point = m.tool.surface.nearest_of(p, last.facet, last.rival);
  if (point.inside && m.contact.neighbours->is_well_inside(p, point.facet)) return {}; // it may have a plane again
  if (point.facet != last.facet) std::swap(last.facet, last.rival);
  return FacetNeighbours::Nearest{point, 0.0, p};
}

/// The nearest point of all, and what is remembered of it.
FacetNeighbours::Nearest nearest(const Search& m, const Vec3& p, int node)
{
  ContactPlanes& planes = m.planes;
  // At the start the node before, of the same block, tells best where to begin.
  const bool follows = planes.found[node].facet < 0 && node % NodeLanes::size > 0;
  const FacetNeighbours::Nearest found = m.contact.neighbours->nearest(p, planes.found[follows ? node - 1 : node].facet);
  planes.found[node] = {found.point.facet, found.rival, told(found.clear, p)};
  return found;
}

/// Whether a node is known to be away from the tool, or nothing is known of it.
bool may_be_away(const ContactPlanes& planes, int node)
{
  if (planes.offset[node] > no_plane) return false;
  return planes.found[node].facet < 0 || planes.reach_squared[node] > 0.0F;
}

/// Nobody in the ball that the node before is in can touch the tool: that will do for a node well inside it.
bool is_in_ball_before(const Search& m, const Vec3& p, int node)
{
  ContactPlanes& planes = m.planes;
  const int before = node - 1;
  if (node % NodeLanes::size == 0 || planes.found[before].facet < 0 || !may_be_away(planes, before)) return false;
  const double reach = std::sqrt(planes.reach_squared[before]);
  if (from_anchor(planes, before, p) + rounding(p) > 0.5 * reach) return false;
  planes.found[node] = {planes.found[before].facet, -1, -1.0F};
  planes.anchor_x[node] = planes.anchor_x[before];
  planes.anchor_y[node] = planes.anchor_y[before];
  planes.anchor_z[node] = planes.anchor_z[before];
  planes.reach_squared[node] = planes.reach_squared[before];
  return true;
}

/// A node that was away from the tool and still is: how far away will do.
bool is_still_away(const Search& m, const Vec3& p, int node)
{
  ContactPlanes& planes = m.planes;
  if (!may_be_away(planes, node)) return false;
  if (is_in_ball_before(m, p, node)) return true;
  if (planes.found[node].facet < 0) return false;
  const double beyond = from_anchor(planes, node, p) - std::sqrt(planes.reach_squared[node]) + rounding(p);
  const auto far = m.contact.neighbours->far(p, planes.found[node].facet, beyond);
  if (!far) return false;
  const float reach = told(far->distance - m.contact.half_thickness, p);
  planes.found[node] = {far->facet, -1, -1.0F};
  set_anchor(planes, node, p);
  planes.reach_squared[node] = reach * reach;
  return true;
}

} // namespace

void search_plane(const Contact& contact, const Tool& tool, ContactPlanes& planes, const Vec3& p, int node)
{
  const Search m{contact, tool, planes};
  if (is_still_away(m, p, node)) return;
  const auto known = where_it_was(m, p, node);
  const FacetNeighbours::Nearest found = known ? *known : nearest(m, p, node);
  const SurfacePoint& point = found.point;
  // Behind the rim of an open surface there is no tool.
  const bool behind_rim = point.distance < 0.0 && point.on_border;
  const double gap = behind_rim ? 0.0 : (point.distance - contact.half_thickness) * (1.0 - 1e-9);
  const double reach = std::max(found.reach, gap);
  const Vec3& anchor = gap > found.reach ? p : found.anchor;
  if (known && reach > 0.0) planes.found[node].clear -= static_cast<float>(from_anchor(planes, node, p) + rounding(p));
  if (!known || reach > 0.0) set_anchor(planes, node, anchor);
  const float sure = told(reach, anchor);
  planes.reach_squared[node] = sure > 0.0F ? sure * sure : -1.0F;
  planes.normal_x[node] = point.normal.x;
  planes.normal_y[node] = point.normal.y;
  planes.normal_z[node] = point.normal.z;
  if (behind_rim || gap > found.reach)
    planes.offset[node] = no_plane;
  else if (point.inside)
    planes.offset[node] = tool.surface.tree().facet(point.facet).offset;
  else
    planes.offset[node] = dot(point.normal, p) - point.distance;
  const int group = node / NodeLanes::group, first = group * NodeLanes::group;
  planes.near[group] = std::any_of(planes.offset.begin() + first, planes.offset.begin() + first + NodeLanes::group,
                                   [](double offset) { return offset > no_plane; })
                           ? 1
                           : 0;
}

double least_distance(const Contact& contact, const ContactState& c, std::size_t node, const Vec3& p)
{
  const ContactPlanes& planes = c.planes;
  if (!(planes.reach_squared[node] > 0.0F) || planes.offset[node] > no_plane) return 0.0;
  const double moved = from_anchor(planes, static_cast<int>(node), p) + rounding(p);
  return std::max(0.0, contact.half_thickness + std::sqrt(planes.reach_squared[node]) - moved);
}

std::optional<double> distance_from_plane(const ContactPlanes& planes, std::size_t node, const Vec3& p)
{
  if (!(planes.reach_squared[node] > 0.0F) || !(planes.offset[node] > no_plane)) return {};
  const double moved = from_anchor(planes, static_cast<int>(node), p) + rounding(p);
  if (moved >= std::sqrt(planes.reach_squared[node])) return {};
  return dot({planes.normal_x[node], planes.normal_y[node], planes.normal_z[node]}, p) - planes.offset[node];
}

} // namespace towform
