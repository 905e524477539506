#include "element/bending.hpp"
#include "parallel/parallel.hpp"
#include <array>
#include <cmath>
#include <stdexcept>

namespace towform {

namespace {

/// Enough for uniform bending to be exact to some 1e-4; see moment_balance.hpp.
constexpr int balance_rounds = 50;

/// Turns items of nodes into lists of points: `point_of(item)`, ascending per point.
template <class Items, class PointOf>
std::vector<int> offsets(const Items& items, std::size_t points, const PointOf& point_of)
{
  std::vector<int> first(points + 1, 0);
  for (const auto& item : items) ++first[static_cast<std::size_t>(point_of(item)) + 1];
  for (std::size_t i = 0; i < points; ++i) first[i + 1] += first[i];
  return first;
}

} // namespace

Bending::Bending(const Blank& blank, std::span<const SymmetryLine> clamped, std::vector<double> node_area,
                 MomentLaw of_warp, MomentLaw of_weft)
    : curvature(blank, clamped, balance_rounds), area(std::move(node_area)), warp(std::move(of_warp)),
      weft(std::move(of_weft))
{
  if (!curvature.complete())
    throw std::invalid_argument("the blank has too few elements to tell its curvature; bending needs more");
  const std::size_t nodes = curvature.nodes(), points = nodes + curvature.images.size();
  first_share = offsets(curvature.terms, points, [](const CurvatureOperator::Term& t) { return t.point; });
  shares.resize(curvature.terms.size());
  std::vector<int> next(first_share.begin(), first_share.end() - 1);
  for (std::size_t n = 0; n < nodes; ++n)
    for (int t = curvature.first[n]; t < curvature.first[n + 1]; ++t) {
      const CurvatureOperator::Term& term = curvature.terms[t];
      shares[next[term.point]++] = {static_cast<int>(n), term.warp, term.weft};
    }
  std::vector<int> end_points;
  for (const CurvatureOperator::Chords& c : curvature.chords)
    end_points.insert(end_points.end(), {c.a0, c.a1, c.b0, c.b1});
  first_end = offsets(end_points, points, [](int point) { return point; });
  ends.resize(end_points.size());
  next.assign(first_end.begin(), first_end.end() - 1);
  for (std::size_t i = 0; i < end_points.size(); ++i) ends[next[end_points[i]]++] = static_cast<unsigned>(i);
}

std::vector<double> Bending::frequency_bound(std::span<const double> mass) const
{
  const std::array<double, 2> stiffness{warp.stiffness(), weft.stiffness()};
  std::vector<double> bound(mass.size(), 0.0);
  for (std::size_t n = 0; n < curvature.nodes(); ++n) {
    std::array<double, 2> sum{};
    for (int t = curvature.first[n]; t < curvature.first[n + 1]; ++t) {
      sum[0] += std::abs(curvature.terms[t].warp);
      sum[1] += std::abs(curvature.terms[t].weft);
    }
    for (int t = curvature.first[n]; t < curvature.first[n + 1]; ++t) {
      const CurvatureOperator::Term& term = curvature.terms[t];
      const auto point = static_cast<std::size_t>(term.point);
      const std::size_t node = point < mass.size()
                                   ? point
                                   : static_cast<std::size_t>(curvature.images[point - mass.size()].source);
      bound[node] +=
          area[n] *
          (stiffness[0] * sum[0] * std::abs(term.warp) + stiffness[1] * sum[1] * std::abs(term.weft)) /
          mass[node];
    }
  }
  return bound;
}

void start(const Bending& bending, std::span<const Vec3> position, BendingState& b)
{
  b.curvature = bending.curvature.at(position);
  b.damping.assign(position.size(), 0.0);
  b.moments.assign(position.size(), {});
  b.turning.assign(2 * position.size(), {});
  b.image.assign(bending.curvature.images.size(), {});
  b.image_force.assign(bending.curvature.images.size(), {});
}

namespace {

void nodal_moments(const Bending& bending, BendingState& b, const State& s, double dt, std::ptrdiff_t begin,
                   std::ptrdiff_t end)
{
  const CurvatureOperator& op = bending.curvature;
  const ImagedPositions x(s.position, b.image);
  const double warp_viscosity = bending.warp.stiffness() * bending.damping_time / dt;
  const double weft_viscosity = bending.weft.stiffness() * bending.damping_time / dt;
  for (std::ptrdiff_t n = begin; n < end; ++n) {
    Vec3 warp, weft;
    for (int t = op.first[n]; t < op.first[n + 1]; ++t) {
      const CurvatureOperator::Term& term = op.terms[t];
      const Vec3& p = x[term.point];
      warp += term.warp * p;
      weft += term.weft * p;
    }
    const CurvatureOperator::Chords& c = op.chords[n];
    const Vec3 a = x[c.a1] - x[c.a0], chord_b = x[c.b1] - x[c.b0];
    const Vec3 across = cross(a, chord_b);
    const double inverse = 1.0 / norm(across);
    const Vec3 normal = inverse * across;
    const YarnPair now{dot(normal, warp), dot(normal, weft)};
    const YarnPair change{now.warp - b.curvature[n].warp, now.weft - b.curvature[n].weft};
    const double area = bending.area[n];
    const double warp_moment = area * (bending.warp.moment(now.warp) + warp_viscosity * change.warp);
    const double weft_moment = area * (bending.weft.moment(now.weft) + weft_viscosity * change.weft);
    b.damping[n] +=
        area * (warp_viscosity * change.warp * change.warp + weft_viscosity * change.weft * change.weft);
    b.curvature[n] = now;
    // dkappa = n . d(x,ii) + x,ii . dn, of which only the part in the surface turns the normal.
    const Vec3 turning =
        inverse * (warp_moment * (warp - now.warp * normal) + weft_moment * (weft - now.weft * normal));
    b.moments[n] = {normal, warp_moment, weft_moment};
    b.turning[2 * n] = cross(chord_b, turning);
    b.turning[2 * n + 1] = cross(turning, a);
  }
}

Vec3 force_on(const Bending& bending, const BendingState& b, std::ptrdiff_t point)
{
  Vec3 force;
  for (int i = bending.first_share[point]; i < bending.first_share[point + 1]; ++i) {
    const Bending::Share& share = bending.shares[i];
    const BendingState::Moments& m = b.moments[share.node];
    force -= (share.warp * m.warp + share.weft * m.weft) * m.normal;
  }
  for (int i = bending.first_end[point]; i < bending.first_end[point + 1]; ++i) {
    const unsigned end = bending.ends[i];
    force += (end % 2 == 0 ? 1.0 : -1.0) * b.turning[end / 2];
  }
  return force;
}

} // namespace

void bending_forces(const Bending& bending, BendingState& b, State& s, double dt)
{
  const std::vector<MirrorImage>& images = bending.curvature.images;
  for (std::size_t i = 0; i < images.size(); ++i) b.image[i] = images[i].position(s.position);
  const auto nodes = static_cast<std::ptrdiff_t>(s.position.size());
  const auto points = nodes + static_cast<std::ptrdiff_t>(images.size());
  parallel_ranges(nodes, [&](auto begin, auto end) { nodal_moments(bending, b, s, dt, begin, end); });
  parallel_ranges(points, [&](auto begin, auto end) {
    for (auto p = begin; p < end; ++p) {
      if (p < nodes)
        s.force[p] += force_on(bending, b, p);
      else
        b.image_force[p - nodes] = force_on(bending, b, p);
    }
  });
  for (std::size_t i = 0; i < images.size(); ++i) images[i].hand_on(b.image_force[i], s.force);
}

double bending_energy(const Bending& bending, const BendingState& b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < b.curvature.size(); ++n)
    sum += bending.area[n] *
           (bending.warp.energy(b.curvature[n].warp) + bending.weft.energy(b.curvature[n].weft));
  return sum;
}

} // namespace towform
