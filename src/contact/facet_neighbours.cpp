#include "contact/facet_neighbours.hpp"
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
  for (const std::atomic<const InFront*>& list : in_front_) delete list.load();
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

void FacetNeighbours::fill(int number, InFront& list) const
{
  static thread_local std::vector<int> found;
  const Facet& f = surface_.tree().facet(number);
  surface_.tree().find_in_box_round(f, radius_, found);
  std::vector<Neighbour> ahead;
  for (const int near : found) {
    const Facet& other = surface_.tree().facet(near);
    constexpr double touching = 1e-12; // [m]
    const bool reaches = std::any_of(other.corner.begin(), other.corner.end(),
                                     [&](const Vec3& c) { return f.height(c) > touching; });
    if (near == number || !reaches || !within(f, other, radius_)) continue;
    const double turn = norm(other.normal - f.normal);
    ahead.push_back({other.normal, other.offset, turn > 0.0 ? 1.0 / turn : 0.0, near});
  }
  const auto others = std::partition(ahead.begin(), ahead.end(),
                                     [&](const Neighbour& n) { return lies_round(number, n.facet); });
  list.round = static_cast<std::size_t>(others - ahead.begin());
  list.facets.assign(ahead.begin(), ahead.end()); // no room for more
}

void FacetNeighbours::fill(int number, All& list) const
{
  const Facet& f = surface_.tree().facet(number);
  surface_.tree().find_in_box_round(f, radius_, list);
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
    const int next = edge < 0 ? -1 : surface_.across(facet, edge);
    if (next < 0 || next == before) break;
    before = facet;
    facet = next;
  }
  return facet;
}

/// Whether another facet lies beyond an edge of a facet, or of one that goes on in its plane.
bool FacetNeighbours::lies_round(int facet, int other) const
{
  for (int k = 0; k < 3; ++k) {
    const int next = surface_.across(facet, k);
    if (next == other) return true;
    if (!surface_.goes_on(facet, k)) continue;
    for (int j = 0; j < 3; ++j)
      if (surface_.across(next, j) == other) return true;
  }
  return false;
}

/// How far p, at a height in front of a facet's plane, may move there, `most` at most, before one of others may be nearer
/// than the inside of the facet. Facets behind the plane can come no nearer, one in front of it not before p is on the plane
/// that halves the angle between both. Negative where another facet is nearer, or as near.
double FacetNeighbours::reach_before(std::span<const Neighbour> others, const Vec3& p, double height, double most) const
{
  double reach = most;
  for (const Neighbour& n : others) {
    if (const double to_bisector = (n.height(p) - height) * n.over_turn; to_bisector > doubt) {
      reach = std::min(reach, to_bisector);
      continue;
    }
    const double distance = std::sqrt(nearest_on_facet(surface_.tree().facet(n.facet), p).distance_squared);
    if (distance <= height + doubt) return -1.0;
    reach = std::min(reach, 0.5 * (distance - height));
  }
  return reach;
}

bool FacetNeighbours::is_well_inside(const Vec3& p, int facet) const { return margin(p, facet) > doubt; }

/// How far p, inside a facet, is from where another plane begins: edges to a facet of the same plane, to the last bit,
/// do not count, but that facet's other edges do.
double FacetNeighbours::margin(const Vec3& p, int facet) const
{
  const Facet& f = surface_.tree().facet(facet);
  double margin = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    if (!surface_.goes_on(facet, k)) {
      margin = std::min(margin, dot(f.inward[k], p - f.corner[k]));
      continue;
    }
    const int next = surface_.across(facet, k);
    const Facet& other = surface_.tree().facet(next);
    for (int j = 0; j < 3; ++j)
      if (surface_.across(next, j) != facet) margin = std::min(margin, dot(other.inward[j], p - other.corner[j]));
  }
  return margin;
}

std::optional<FacetNeighbours::Nearest> FacetNeighbours::still_inside(const Vec3& p, int facet, double clear) const
{
  const double height = surface_.tree().facet(facet).height(p), room = margin(p, facet);
  if (!(height > 0.0 && room > doubt)) return {};
  const double reach = reach_before(of(facet, in_front_).those_round(), p, height, std::min(room, clear));
  if (reach < 0.0) return {};
  return Nearest{surface_.above(p, facet), std::max(0.0, reach - 0.1 * doubt), -1, clear};
}

FacetNeighbours::Nearest FacetNeighbours::nearest(const Vec3& p, int from) const
{
  // A facet as near as the found one is within twice the distance of it.
  const auto is_far = [this](double distance_squared) { return 4.0 * distance_squared >= radius_ * radius_; };
  int facet = from < 0 ? from : walk(p, from);
  FacetPoint best;
  if (facet >= 0) best = nearest_on_facet(surface_.tree().facet(facet), p);
  if (facet < 0 || is_far(best.distance_squared)) {
    const SurfacePoint found = surface_.nearest(p, facet);
    if (is_far(found.distance * found.distance)) return Nearest{found};
    facet = found.facet;
    best = nearest_on_facet(surface_.tree().facet(facet), p);
  }
  if (const double height = surface_.tree().facet(facet).height(p); best.feature == Feature::inside && height > 0.0) {
    if (const double room = margin(p, facet); room > doubt) {
      const InFront& ahead = of(facet, in_front_);
      const double clear = reach_before(ahead.others(), p, height, 0.5 * radius_ - height);
      const double reach = reach_before(ahead.those_round(), p, height, std::min(room, clear));
      if (clear >= 0.0 && reach >= 0.0)
        return Nearest{surface_.at(p, facet, best), std::max(0.0, reach - 0.1 * doubt), -1, clear - 0.1 * doubt};
    }
  }
  for (const int near : of(facet, all_)) {
    const Facet& other = surface_.tree().facet(near);
    const double height = other.height(p);
    if (height * height > best.distance_squared) continue;
    const FacetPoint point = nearest_on_facet(other, p);
    if (point.distance_squared < best.distance_squared ||
        (point.distance_squared == best.distance_squared && near < facet)) {
      best = point;
      facet = near;
    }
  }
  Nearest found{surface_.at(p, facet, best)};
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
    const Facet& other = surface_.tree().facet(near);
    if (near == found.rival || std::abs(other.height(p)) >= third) continue;
    third = std::min(third, std::sqrt(nearest_on_facet(other, p).distance_squared));
  }
  found.clear = 0.5 * (third - distance) - doubt;
  if (found.clear > 0.0) return;
  found.clear = 0.0;
  found.rival = -1;
}

} // namespace towform
