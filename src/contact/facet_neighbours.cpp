#include "contact/facet_neighbours.hpp"
#include "contact/level.hpp"
#include <algorithm>
#include <cmath>
#include <memory>

namespace towform {

namespace {

/// Who is nearer to an edge than this is not taken to be inside, and another facet's plane that is not farther by
/// more decides nothing: such cases are settled by exact distances.
constexpr double doubt = 1e-6; // [m]

/// Whether a whole facet lies beyond the plane through edge k of another, square to that, by more than `radius`.
bool beyond_an_edge(const Facet& other, const Facet& f, double radius)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (std::all_of(other.corner.begin(), other.corner.end(),
                    [&](const Vec3& c) { return dot(f.inward[k], c - f.corner[k]) < -radius; }))
      return true;
  return false;
}

/// Whether p is above or below a facet, not beside it.
bool is_above(const Vec3& p, const Facet& f)
{
  return dot(f.inward[0], p - f.corner[0]) >= 0.0 && dot(f.inward[1], p - f.corner[1]) >= 0.0 &&
         dot(f.inward[2], p - f.corner[2]) >= 0.0;
}

bool within(const Facet& f, const Facet& other, double radius)
{
  const auto off_plane = [radius](const Facet& a, const Facet& b) {
    const auto above = [&](const Vec3& c) { return a.height(c) > radius; };
    const auto below = [&](const Vec3& c) { return a.height(c) < -radius; };
    return std::all_of(b.corner.begin(), b.corner.end(), above) ||
           std::all_of(b.corner.begin(), b.corner.end(), below);
  };
  return !off_plane(f, other) && !off_plane(other, f) && !beyond_an_edge(other, f, radius) &&
         !beyond_an_edge(f, other, radius);
}

} // namespace

FacetNeighbours::~FacetNeighbours()
{
  for (const std::atomic<const Competitors*>& list : competitors_) delete list.load();
  for (const std::atomic<const All*>& list : all_) delete list.load();
}

template <class List>
const List& FacetNeighbours::of(int facet, Lists<List>& lists) const
{
  if (const List* list = lists[facet].load(std::memory_order_acquire)) return *list;
  auto made = std::make_unique<List>();
  fill(facet, *made);
  const List* there = nullptr;
  if (lists[facet].compare_exchange_strong(there, made.get(), std::memory_order_acq_rel)) return *made.release();
  return *there; // another thread was first, with the same list
}

/// The corners of a facet and of those that go on in its plane, three each.
void FacetNeighbours::find_level(int number, std::vector<Vec3>& corners) const
{
  corners.clear();
  const auto take = [&](int facet) {
    const auto& its = surface_.tree().facet(facet).corner;
    corners.insert(corners.end(), its.begin(), its.end());
  };
  take(number);
  for (int k = 0; k < 3; ++k)
    if (surface_.goes_on(number, k)) take(surface_.across(number, k));
}

/// Whether another facet may be nearer, or as near, to who is above one, no higher than `highest`, that has the corners `level`
/// with those that go on in its plane. Distances from planes, being linear, are told by their values at the ends of that space.
bool FacetNeighbours::competes(const Facet& other, const Facet& f, std::span<const Vec3> level, double highest)
{
  constexpr double touching = 1e-12; // [m]
  const std::array heights{f.height(other.corner[0]), f.height(other.corner[1]), f.height(other.corner[2])};
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  if (*high <= touching || *low > 2.0 * highest) return false;
  bool before = true, behind = true;
  for (const Vec3& corner : level)
    for (const double height : {0.0, highest}) {
      const double from_other = other.height(corner + height * f.normal);
      before = before && from_other - height > doubt;
      behind = behind && from_other + height < -doubt;
    }
  return !before && !behind;
}

/// A facet's competitors for who is above `space`, it and what is `level` with it, no higher than `highest`, out of `some` that are
/// near.
FacetNeighbours::Competitors FacetNeighbours::competitors(int number, double highest, double level, std::span<const Vec3> space,
                                                          std::span<const int> some) const
{
  const Facet& f = surface_.tree().facet(number);
  Competitors list{{}, highest, level};
  for (const int near : some) {
    const Facet& other = surface_.tree().facet(near);
    if (!competes(other, f, space, highest)) continue;
    bool beside = beyond_an_edge(other, f, highest + level);
    for (int k = 0; k < 3 && beside; ++k)
      if (surface_.goes_on(number, k)) beside = beyond_an_edge(other, surface_.tree().facet(surface_.across(number, k)), highest);
    if (beside) continue;
    const double turn = norm(other.normal - f.normal);
    list.facets.push_back({other.normal, other.offset, turn > 0.0 ? 1.0 / turn : 0.0, near});
  }
  return list;
}

/// Lists serve as high as the facet is long, or as far as it is level, where that brings no competitors: above a level part of
/// a tool.
void FacetNeighbours::fill(int number, Competitors& list) const
{
  constexpr double most_level = 6e-3; // [m]; the farther, the longer takes the list
  static thread_local std::vector<int> near;
  static thread_local std::vector<Vec3> base, space;
  const Facet& f = surface_.tree().facet(number);
  const double level = level_room(surface_, number, most_level);
  find_level(number, base);
  if (level > 0.0) {
    const Vec3 along = level * normalized(f.edge(0)), across = level * f.inward[0];
    for (const Vec3& corner : f.corner)
      for (const Vec3& side : {along + across, along - across, across - along, -along - across}) base.push_back(corner + side);
  }
  const auto look = [&](double highest) {
    space = base;
    for (const Vec3& corner : base) space.push_back(corner + highest * f.normal);
    surface_.tree().find_in_front(f, space, highest, near);
  };
  look(highest_);
  list = competitors(number, highest_, level, base, near);
  const double length = std::max({norm(f.edge(0)), norm(f.edge(1)), norm(f.edge(2)), level});
  double most = highest_;
  while (2.0 * most <= length) most *= 2.0;
  if (list.facets.empty() && most > highest_) {
    look(most);
    for (double highest = 2.0 * highest_; highest <= most; highest *= 2.0) {
      Competitors higher = competitors(number, highest, level, base, near);
      if (!higher.facets.empty()) break;
      list = std::move(higher);
    }
  }
  list.facets.shrink_to_fit();
}

void FacetNeighbours::fill(int number, All& list) const
{
  const Facet& f = surface_.tree().facet(number);
  surface_.tree().find_in_box_round(f.corner, radius_, list);
  std::erase_if(list, [&](int near) { return near == number || !within(f, surface_.tree().facet(near), radius_); });
  list.shrink_to_fit();
}

/// Steps over the edge that p is farthest beyond, as long as that leads on.
int FacetNeighbours::walk(const Vec3& p, int from) const
{
  constexpr int most_steps = 8;
  int facet = from, before = -1;
  for (int step = 0; step < most_steps; ++step) {
    const Facet& f = surface_.tree().facet(facet);
    double farthest = 0.0;
    int edge = -1;
    for (int k = 0; k < 3; ++k)
      if (const double inside = dot(f.inward[k], p - f.corner[k]); inside < farthest) {
        farthest = inside;
        edge = k;
      }
    const int next = edge < 0 ? -1 : f.across[edge];
    if (next < 0 || next == before) break;
    before = facet;
    facet = next;
  }
  return facet;
}

bool FacetNeighbours::is_well_inside(const Vec3& p, int facet) const
{
  Limits limits;
  see_margin(p, facet, limits);
  return limits.nearest.room > doubt;
}

/// How far p, inside a facet, is from where another plane begins: edges to a facet of the same plane, to the last bit,
/// do not count, but that facet's other edges do.
void FacetNeighbours::see_margin(const Vec3& p, int facet, Limits& limits) const
{
  const Facet& f = surface_.tree().facet(facet);
  const auto see = [&](const Facet& of, int k) {
    const Vec3& inward = of.inward[static_cast<std::size_t>(k)];
    limits.see(dot(inward, p - of.corner[static_cast<std::size_t>(k)]), inward);
  };
  for (int k = 0; k < 3; ++k) {
    if (!f.goes_on[k]) {
      see(f, k);
      continue;
    }
    const Facet& next = surface_.tree().facet(f.across[k]);
    for (int j = 0; j < 3; ++j)
      if (next.across[j] != facet) see(next, j);
  }
}

/// How far p, at a height above a facet, may move there before another facet may be nearer. Facets behind the plane can come no
/// nearer, one in front of it not before p is on the plane that halves the angle between both. False where another facet is
/// nearer, or as near, or where it is not known.
bool FacetNeighbours::reach_above(const Vec3& p, int facet, double height, Limits& limits) const
{
  see_margin(p, facet, limits);
  if (!(limits.nearest.room > doubt)) return false;
  const Competitors& list = of(facet, competitors_);
  const Facet& f = surface_.tree().facet(facet);
  const Vec3& normal = f.normal;
  if (list.level > limits.nearest.room && is_above(p, f)) {
    limits.clear();
    limits.see(list.level, {});
  }
  limits.see(list.highest - height, -normal);
  if (!(limits.nearest.room > doubt)) return false;
  for (const Neighbour& n : list.facets) {
    if (const double to_bisector = (n.height(p) - height) * n.over_turn; to_bisector > doubt) {
      limits.see(to_bisector, n.over_turn * (n.normal - normal));
      continue;
    }
    // It is not before the plane through its nearest point square to the way there, which stands for its own.
    const FacetPoint point = nearest_on_facet(surface_.tree().facet(n.facet), p);
    const double distance = std::sqrt(point.distance_squared);
    if (distance <= height + doubt) return false;
    const Vec3 turn = (1.0 / distance) * (p - point.point) - normal;
    const double size = norm(turn);
    if (const double room = distance - height; room < limits.nearest.room * size) limits.see(room / size, (1.0 / size) * turn);
  }
  return true;
}

/// Who has just come over an edge is near it, and would soon be looked for again: a ball that has him inside, but its middle
/// farther from there, reaches farther. It goes as far from the nearest limit as from the next. Where the plane ends on a level
/// part has no direction.
void FacetNeighbours::widen(const Vec3& p, double height, const Limits& limits, Nearest& found) const
{
  const auto& [least, away] = limits.nearest;
  if (norm_squared(away) == 0.0) return;
  const Facet& f = surface_.tree().facet(found.point.facet);
  double step = 2.0 * radius_;
  if (const double sinking = -dot(f.normal, away); sinking > 0.0) step = std::min(step, 0.9 * height / sinking);
  for (std::size_t i = 0; i < limits.count; ++i)
    if (const double closing = 1.0 - dot(limits.seen[i].away, away); closing > 1e-6)
      step = std::min(step, (limits.seen[i].room - least) / closing);
  constexpr int tries = 2; // what is beside p may be nearer than it seems from there
  for (int i = 0; i < tries && step > std::max(2.0 * found.reach, 0.03 * radius_); ++i, step *= 0.5) {
    const Vec3 centre = p + step * away;
    Limits there;
    if (!reach_above(centre, found.point.facet, f.height(centre), there)) continue;
    const double reach = there.nearest.room - 0.1 * doubt;
    if (reach <= step + 0.5 * found.reach) continue;
    found.reach = reach;
    found.anchor = centre;
    return;
  }
}

FacetNeighbours::Nearest FacetNeighbours::nearest(const Vec3& p, int from) const
{
  int facet = from < 0 ? from : walk(p, from);
  FacetPoint best;
  if (facet >= 0) best = nearest_on_facet(surface_.tree().facet(facet), p);
  const auto above = [&]() -> std::optional<Nearest> {
    const double height = surface_.tree().facet(facet).height(p);
    if (best.feature != Feature::inside || !(height > 0.0)) return {};
    Limits limits;
    if (!reach_above(p, facet, height, limits)) return {};
    Nearest found{surface_.at(p, facet, best), std::max(0.0, limits.nearest.room - 0.1 * doubt), p};
    widen(p, height, limits, found);
    return found;
  };
  if (facet >= 0)
    if (const auto found = above()) return *found;
  // A facet as near as the found one is within twice the distance of it.
  const auto is_far = [this](double distance_squared) { return 4.0 * distance_squared >= radius_ * radius_; };
  if (facet < 0 || is_far(best.distance_squared)) {
    const SurfacePoint point = surface_.nearest(p, facet);
    const bool same = point.facet == facet;
    facet = point.facet;
    best = nearest_on_facet(surface_.tree().facet(facet), p);
    if (!same)
      if (const auto found = above()) return *found;
    if (is_far(best.distance_squared)) return Nearest{point, 0.0, p};
  }
  const int tried = facet;
  for (const int near : of(facet, all_)) {
    if (surface_.tree().least_distance_squared(p, near) > best.distance_squared) continue;
    const FacetPoint point = nearest_on_facet(surface_.tree().facet(near), p);
    if (point.distance_squared < best.distance_squared ||
        (point.distance_squared == best.distance_squared && near < facet)) {
      best = point;
      facet = near;
    }
  }
  if (facet != tried)
    if (const auto found = above()) return *found;
  Nearest found{surface_.at(p, facet, best), 0.0, p};
  if (best.feature < Feature::corner_0) set_rival(p, best, found);
  return found;
}

std::optional<FacetNeighbours::Far> FacetNeighbours::far(const Vec3& p, int from, double beyond) const
{
  if (beyond >= 0.5 * radius_) return {};
  const int start = walk(p, from);
  const double at_most = std::sqrt(nearest_on_facet(surface_.tree().facet(start), p).distance_squared);
  if (at_most < radius_) return {};
  const FacetTree::Roughly rough = surface_.tree().roughly_nearest(p, at_most);
  if (rough.no_nearer < 0.5 * radius_) return {};
  return Far{rough.facet < 0 ? start : rough.facet, rough.no_nearer};
}

/// The edge of a facet that p is on, or comes to first.
int FacetNeighbours::edge_of(const Vec3& p, int facet, Feature feature) const
{
  if (feature != Feature::inside) return edge_number(feature);
  const Facet& f = surface_.tree().facet(facet);
  const auto room = [&](std::size_t k) { return dot(f.inward[k], p - f.corner[k]); };
  return room(0) <= room(1) ? (room(0) <= room(2) ? 0 : 2) : (room(1) <= room(2) ? 1 : 2);
}

/// Facets that are not on the list are farther from the found one than the radius.
void FacetNeighbours::set_rival(const Vec3& p, const FacetPoint& best, Nearest& found) const
{
  found.rival = surface_.across(found.point.facet, edge_of(p, found.point.facet, best.feature));
  const double distance = std::sqrt(best.distance_squared);
  double third = radius_ - distance;
  for (const int near : of(found.point.facet, all_)) {
    if (near == found.rival || surface_.tree().least_distance_squared(p, near) >= third * third) continue;
    third = std::min(third, std::sqrt(nearest_on_facet(surface_.tree().facet(near), p).distance_squared));
  }
  found.clear = 0.5 * (third - distance) - doubt;
  if (found.clear > 0.0) return;
  found.clear = 0.0;
  found.rival = -1;
}

} // namespace towform
