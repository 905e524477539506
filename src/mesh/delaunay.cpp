#include "mesh/delaunay.hpp"
#include "mesh/point_order.hpp"
#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

namespace towform {
namespace {

__extension__ using Wide = __int128;

constexpr double lattice = 1u << 26; // keeps the in-circle determinant below 2^110

struct LatticePoint {
  std::int64_t x, y;
};

std::vector<LatticePoint> snapped(std::span<const Vec2> points)
{
  Vec2 low = points.front(), high = low;
  for (const Vec2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double scale = lattice / std::max({high.x - low.x, high.y - low.y, 1e-300});
  std::vector<LatticePoint> result;
  result.reserve(points.size());
  for (const Vec2& p : points) {
    result.push_back({std::llround((p.x - low.x) * scale), std::llround((p.y - low.y) * scale)});
  }
  return result;
}

/// Twice the area of a, b, c; positive counter-clockwise.
std::int64_t orientation(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Is p strictly inside the circle through the counter-clockwise a, b, c?
bool in_circle(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& p)
{
  const std::int64_t ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y, cx = c.x - p.x,
                     cy = c.y - p.y;
  const auto product = [](std::int64_t u, std::int64_t v) { return static_cast<Wide>(u) * v; };
  return product(ax * ax + ay * ay, bx * cy - by * cx) + product(bx * bx + by * by, cx * ay - cy * ax) +
             product(cx * cx + cy * cy, ax * by - ay * bx) >
         0;
}

/// Points in rounds that double in size, at random but the same everywhere, each along a Hilbert curve: the
/// triangle last made is then near the next point, and no order of the input makes the work quadratic.
std::vector<int> insertion_order(std::span<const Vec2> points)
{
  std::vector<int> order = hilbert_order(points);
  const auto round = [](int point) {
    auto h = static_cast<std::uint64_t>(point) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93u;
    return std::countr_zero(h | (std::uint64_t{1} << 20));
  };
  std::vector<int> rounds(points.size());
  for (std::size_t k = 0; k < rounds.size(); ++k) rounds[k] = round(static_cast<int>(k));
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rounds[a] > rounds[b]; });
  return order;
}

/// The triangulation under construction. Ghost triangles join every edge of the hull to one point at
/// infinity, so that points outside the hull need no case of their own.
class Builder {
public:
  explicit Builder(std::span<const Vec2> points)
      : points_(snapped(points)), ghost_(static_cast<int>(points.size())), first_(points.size() + 1, -1)
  {
    corners_.reserve(2 * points.size() + 2);
    neighbours_.reserve(2 * points.size() + 2);
    mark_.reserve(2 * points.size() + 2);
  }

  void build(std::vector<int> order)
  {
    bring_a_triangle_forward(order);
    begin(order[0], order[1], order[2]);
    for (std::size_t k = 3; k < order.size(); ++k) insert(order[k]);
  }

  /// The triangles without ghosts.
  [[nodiscard]] Triangulation result() const
  {
    std::vector<int> number(corners_.size(), -1);
    Triangulation r;
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      if (is_ghost(corners_[t])) continue;
      number[t] = static_cast<int>(r.triangles.size());
      r.triangles.push_back(corners_[t]);
    }
    r.neighbours.reserve(r.triangles.size());
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      if (number[t] < 0) continue;
      const Triangle& n = neighbours_[t];
      r.neighbours.push_back({number[n[0]], number[n[1]], number[n[2]]});
    }
    return r;
  }

private:
  [[nodiscard]] bool is_ghost(const Triangle& t) const
  {
    return t[0] == ghost_ || t[1] == ghost_ || t[2] == ghost_;
  }

  /// Makes the first three points of the order a counter-clockwise triangle.
  void bring_a_triangle_forward(std::vector<int>& order) const
  {
    if (order.size() < 3) throw std::invalid_argument("a triangulation needs three points");
    const LatticePoint &a = points_[order[0]], &b = points_[order[1]];
    const auto third = std::find_if(order.begin() + 2, order.end(),
                                    [&](int c) { return orientation(a, b, points_[c]) != 0; });
    if (third == order.end()) {
      throw std::invalid_argument("a triangulation needs points that differ and do not all lie on a line");
    }
    std::rotate(order.begin() + 2, third, third + 1);
    if (orientation(a, b, points_[order[2]]) < 0) std::swap(order[0], order[1]);
  }

  void begin(int a, int b, int c)
  {
    corners_ = {{a, b, c}, {c, b, ghost_}, {a, c, ghost_}, {b, a, ghost_}};
    neighbours_ = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    mark_ = {0, 0, 0, 0};
    latest_ = 0;
  }

  /// Must t go when p comes?
  [[nodiscard]] bool conflicts(int t, const LatticePoint& p) const
  {
    const Triangle& v = corners_[t];
    const auto ghost = std::find(v.begin(), v.end(), ghost_);
    if (ghost == v.end()) return in_circle(points_[v[0]], points_[v[1]], points_[v[2]], p);
    const auto k = ghost - v.begin();
    const LatticePoint &a = points_[v[(k + 1) % 3]], &b = points_[v[(k + 2) % 3]];
    const std::int64_t side = orientation(a, b, p);
    if (side != 0) return side > 0;
    return (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) < 0; // on the hull's edge itself
  }

  /// A triangle that conflicts with p, by walking towards p from the triangle made last.
  [[nodiscard]] int locate(const LatticePoint& p) const
  {
    int t = latest_;
    const auto ghost = std::find(corners_[t].begin(), corners_[t].end(), ghost_);
    if (ghost != corners_[t].end()) t = neighbours_[t][ghost - corners_[t].begin()];
    for (bool moved = true; moved;) {
      moved = false;
      for (int k = 0; k < 3 && !moved; ++k) {
        const Triangle& v = corners_[t];
        if (orientation(points_[v[(k + 1) % 3]], points_[v[(k + 2) % 3]], p) < 0) {
          t = neighbours_[t][k];
          if (is_ghost(corners_[t])) return t; // p lies outside this edge of the hull
          moved = true;
        }
      }
    }
    for (const int corner : corners_[t]) {
      if (points_[corner].x == p.x && points_[corner].y == p.y) {
        throw std::invalid_argument("two points of a triangulation coincide");
      }
    }
    return t;
  }

  void insert(int point)
  {
    find_cavity(points_[point]);
    // A star of new triangles from the point to the cavity's rim; the rim runs once through each corner.
    while (cavity_.size() < rim_.size()) {
      cavity_.push_back(static_cast<int>(corners_.size()));
      corners_.emplace_back();
      neighbours_.emplace_back();
      mark_.push_back(0);
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      const RimEdge& e = rim_[k];
      const int t = cavity_[k];
      corners_[t] = {e.from, e.to, point};
      neighbours_[t][2] = e.outside;
      neighbours_[e.outside][e.side] = t;
      first_[e.from] = t;
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      const int t = cavity_[k], next = first_[rim_[k].to];
      neighbours_[t][0] = next;
      neighbours_[next][1] = t;
    }
    latest_ = cavity_.front();
  }

  /// The connected triangles that conflict with p, and the edges round them.
  void find_cavity(const LatticePoint& p)
  {
    ++stamp_;
    cavity_.assign(1, locate(p));
    rim_.clear();
    mark_[cavity_.front()] = stamp_;
    for (std::size_t c = 0; c < cavity_.size(); ++c) {
      const int t = cavity_[c];
      for (int k = 0; k < 3; ++k) {
        const int n = neighbours_[t][k];
        if (mark_[n] == stamp_) continue;
        if (conflicts(n, p)) {
          mark_[n] = stamp_;
          cavity_.push_back(n);
          continue;
        }
        const Triangle& back = neighbours_[n];
        const int side = static_cast<int>(std::find(back.begin(), back.end(), t) - back.begin());
        rim_.push_back({corners_[t][(k + 1) % 3], corners_[t][(k + 2) % 3], n, side});
      }
    }
  }

  struct RimEdge {
    int from, to, outside, side; // points, the triangle beyond, and which neighbour of it we are
  };

  std::vector<LatticePoint> points_;
  int ghost_;
  std::vector<Triangle> corners_, neighbours_;
  std::vector<int> mark_, first_, cavity_;
  std::vector<RimEdge> rim_;
  int stamp_ = 0, latest_ = 0;
};

} // namespace

Triangulation delaunay(std::span<const Vec2> points)
{
  if (points.empty()) throw std::invalid_argument("a triangulation needs three points");
  Builder builder(points);
  builder.build(insertion_order(points));
  return builder.result();
}

} // namespace towform
