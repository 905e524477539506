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
  for (const std::atomic<const List*>& list : lists_) delete list.load();
}

const FacetNeighbours::List& FacetNeighbours::make(int number) const
{
  const Facet& f = surface_.tree().facet(number);
  auto made = std::make_unique<List>();
  for (const int near : surface_.tree().in_box_round(f, radius_)) {
    const Facet& other = surface_.tree().facet(near);
    if (near == number || !within(f, other, radius_)) continue;
    const double turn = norm(other.normal - f.normal);
    const Neighbour neighbour{other.normal, other.offset, turn > 0.0 ? 1.0 / turn : 0.0, near};
    const auto reaches = [&](double side) {
      constexpr double touching = 1e-12; // [m]
      return std::any_of(other.corner.begin(), other.corner.end(),
                         [&](const Vec3& c) { return side * f.height(c) > touching; });
    };
    made->all.push_back(neighbour);
    if (reaches(1.0)) made->in_front.push_back(neighbour);
    if (reaches(-1.0)) made->behind.push_back(neighbour);
  }
  const List* there = nullptr;
  if (lists_[number].compare_exchange_strong(there, made.get(), std::memory_order_acq_rel)) return *made.release();
  return *there; // another thread was first, with the same list
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

/// How far p may move while its nearest point stays inside the facet: beyond an edge it may be on that; beyond
/// the facet's plane what lies behind it comes to the front. Facets behind the plane can come no nearer, one
/// in front of it not before p is on the plane that halves the angle between both. Negative where another
/// facet is nearer, or as near.
double FacetNeighbours::reach_inside(const Vec3& p, int facet, double height, double margin) const
{
  const double side = height < 0.0 ? -1.0 : 1.0, size = std::abs(height);
  double reach = std::min({size, margin, 0.5 * radius_ - size});
  const List& list = of(facet);
  for (const Neighbour& n : side > 0.0 ? list.in_front : list.behind) {
    if (const double to_bisector = (side * n.height(p) - size) * n.over_turn; to_bisector > doubt) {
      reach = std::min(reach, to_bisector);
      continue;
    }
    const double distance = std::sqrt(nearest_on_facet(surface_.tree().facet(n.facet), p).distance_squared);
    if (distance <= size + doubt) return -1.0;
    reach = std::min(reach, 0.5 * (distance - size));
  }
  return reach;
}

/// How far p, inside a facet, is from where another plane begins: edges to a facet of the same plane, to the last bit,
/// do not count, but that facet's other edges do.
double FacetNeighbours::margin(const Vec3& p, int facet) const
{
  const Facet& f = surface_.tree().facet(facet);
  double margin = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const int next = surface_.across(facet, k);
    const Facet* other = next < 0 ? nullptr : &surface_.tree().facet(next);
    if (other == nullptr || !(other->normal == f.normal && other->offset == f.offset)) {
      margin = std::min(margin, dot(f.inward[k], p - f.corner[k]));
      continue;
    }
    for (int j = 0; j < 3; ++j)
      if (surface_.across(next, j) != facet)
        margin = std::min(margin, dot(other->inward[j], p - other->corner[j]));
  }
  return margin;
}

std::optional<FacetNeighbours::Nearest> FacetNeighbours::nearest(const Vec3& p, int from) const
{
  int facet = walk(p, from);
  const Facet& f = surface_.tree().facet(facet);
  FacetPoint best = nearest_on_facet(f, p);
  // A facet as near as this one is within twice the distance of it.
  if (4.0 * best.distance_squared >= radius_ * radius_) return {};
  if (best.feature == Feature::inside) {
    if (const double room = margin(p, facet); room > doubt)
      if (const double reach = reach_inside(p, facet, f.height(p), room); reach >= 0.0)
        return Nearest{surface_.at(p, facet, best), std::max(0.0, reach - 0.1 * doubt)};
  }
  for (const Neighbour& n : of(facet).all) {
    const double height = n.height(p);
    if (height * height > best.distance_squared) continue;
    const FacetPoint point = nearest_on_facet(surface_.tree().facet(n.facet), p);
    if (point.distance_squared < best.distance_squared ||
        (point.distance_squared == best.distance_squared && n.facet < facet)) {
      best = point;
      facet = n.facet;
    }
  }
  return Nearest{surface_.at(p, facet, best), 0.0};
}

} // namespace towform
