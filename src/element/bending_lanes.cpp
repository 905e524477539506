#include "element/bending_lanes.hpp"
#include "parallel/vector_clones.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

void VectorLanes::clear(int lanes)
{
  for (double* v : {x, y, z}) std::fill_n(v, lanes + StencilLayout::vector_size, 0.0);
}

namespace {

/// A sum's first three terms.
TOWFORM_VECTOR_CLONES
void sum_three(const StencilTerm* t, const Components& field, int count, double* to_x, double* to_y, double* to_z)
{
  const double *x = field.x, *y = field.y, *z = field.z;
  double* __restrict sx = to_x;
  double* __restrict sy = to_y;
  double* __restrict sz = to_z;
  const double w0 = t[0].weight, w1 = t[1].weight, w2 = t[2].weight;
  const int a0 = t[0].ahead, a1 = t[1].ahead, a2 = t[2].ahead;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    sx[i] = w0 * x[i + a0] + w1 * x[i + a1] + w2 * x[i + a2];
    sy[i] = w0 * y[i + a0] + w1 * y[i + a1] + w2 * y[i + a2];
    sz[i] = w0 * z[i + a0] + w1 * z[i + a1] + w2 * z[i + a2];
  }
}

/// One more.
TOWFORM_VECTOR_CLONES
void add_one(const StencilTerm& t, const Components& field, int count, double* to_x, double* to_y, double* to_z)
{
  const double w = t.weight;
  const double *x = field.x + t.ahead, *y = field.y + t.ahead, *z = field.z + t.ahead;
  double* __restrict sx = to_x;
  double* __restrict sy = to_y;
  double* __restrict sz = to_z;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    sx[i] += w * x[i];
    sy[i] += w * y[i];
    sz[i] += w * z[i];
  }
}

void sum_terms(std::span<const StencilTerm> terms, const Components& field, int count, double* x, double* y, double* z)
{
  if (terms.size() < 3) {
    for (double* v : {x, y, z}) std::fill_n(v, count, 0.0);
  } else {
    sum_three(terms.data(), field, count, x, y, z);
    terms = terms.subspan(3);
  }
  for (const StencilTerm& t : terms) add_one(t, field, count, x, y, z);
}

/// Second derivatives take their multiples of the change.
TOWFORM_VECTOR_CLONES
void change_derivatives(const YarnPair* its_times, int count, BendingLanes& __restrict l)
{
  const YarnPair* __restrict times = its_times;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const double warp = times[i].warp, weft = times[i].weft;
    l.warp_x[i] += warp * l.change_x[i];
    l.warp_y[i] += warp * l.change_y[i];
    l.warp_z[i] += warp * l.change_z[i];
    l.weft_x[i] += weft * l.change_x[i];
    l.weft_y[i] += weft * l.change_y[i];
    l.weft_z[i] += weft * l.change_z[i];
  }
}

TOWFORM_VECTOR_CLONES
void change_moments(const YarnPair* its_times, int count, BendingLanes& __restrict l)
{
  const YarnPair* __restrict times = its_times;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i)
    l.change_moment[i] = times[i].warp * l.warp_moment[i] + times[i].weft * l.weft_moment[i];
}

/// to += factor times each lane's.
TOWFORM_VECTOR_CLONES
void add(double factor, const double* shares, double* sums, int count)
{
  const double* __restrict share = shares;
  double* __restrict sum = sums;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) sum[i] += factor * share[i];
}

/// What a point takes from the forces of moments, all along the nodes' normals.
TOWFORM_VECTOR_CLONES
void take(const StencilPoint& p, const BendingLanes& __restrict l, const Components& from, int count)
{
  const double warp = p.warp, weft = p.weft;
  double* __restrict x = from.x;
  double* __restrict y = from.y;
  double* __restrict z = from.z;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const double share = warp * l.warp_moment[i] + weft * l.weft_moment[i];
    x[i] -= share * l.nx[i];
    y[i] -= share * l.ny[i];
    z[i] -= share * l.nz[i];
  }
}

TOWFORM_VECTOR_CLONES
void take_changed(const StencilPoint& p, const BendingLanes& __restrict l, const Components& from, int count)
{
  const double warp = p.warp, weft = p.weft, change = p.change;
  double* __restrict x = from.x;
  double* __restrict y = from.y;
  double* __restrict z = from.z;
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    const double share = warp * l.warp_moment[i] + weft * l.weft_moment[i] + change * l.change_moment[i];
    x[i] -= share * l.nx[i];
    y[i] -= share * l.ny[i];
    z[i] -= share * l.nz[i];
  }
}

} // namespace

void differentiate(const Stencil& s, const Components& field, int count, BendingLanes& l)
{
  sum_terms(s.warp, field, count, l.warp_x, l.warp_y, l.warp_z);
  sum_terms(s.weft, field, count, l.weft_x, l.weft_y, l.weft_z);
  if (s.change.empty()) return;
  sum_terms(s.change, field, count, l.change_x, l.change_y, l.change_z);
  change_derivatives(s.times, count, l);
}

TOWFORM_VECTOR_CLONES
void draw_chords(const std::array<int, 4>& ends, const Components& position, int count, BendingLanes& __restrict l)
{
  const double *x = position.x, *y = position.y, *z = position.z;
  const int a0 = ends[0], a1 = ends[1], b0 = ends[2], b1 = ends[3];
  TOWFORM_INDEPENDENT
  for (int i = 0; i < count; ++i) {
    l.ax[i] = x[i + a1] - x[i + a0];
    l.ay[i] = y[i + a1] - y[i + a0];
    l.az[i] = z[i + a1] - z[i + a0];
    l.bx[i] = x[i + b1] - x[i + b0];
    l.by[i] = y[i + b1] - y[i + b0];
    l.bz[i] = z[i + b1] - z[i + b0];
  }
}

void spread_moments(const Stencil& s, BendingLanes& l, int count, const Components& force)
{
  if (s.change.empty()) {
    for (const StencilPoint& p : s.points)
      if (p.warp != 0.0 || p.weft != 0.0) take(p, l, force.from(p.ahead), count);
    return;
  }
  change_moments(s.times, count, l);
  for (const StencilPoint& p : s.points) take_changed(p, l, force.from(p.ahead), count);
}

void spread_chords(const std::array<int, 4>& ends, const BendingLanes& l, int count, const Components& force)
{
  const auto& [a0, a1, b0, b1] = ends;
  const auto on_end = [&](double sign, const double* fx, const double* fy, const double* fz, int end) {
    add(sign, fx, force.x + end, count);
    add(sign, fy, force.y + end, count);
    add(sign, fz, force.z + end, count);
  };
  on_end(1.0, l.on_ax, l.on_ay, l.on_az, a0);
  on_end(-1.0, l.on_ax, l.on_ay, l.on_az, a1);
  on_end(1.0, l.on_bx, l.on_by, l.on_bz, b0);
  on_end(-1.0, l.on_bx, l.on_by, l.on_bz, b1);
}

namespace {
/// A vector's components in their lanes.
inline void put(const Vec4& v, int lane, double* x, double* y, double* z)
{
  x[lane] = v[0];
  y[lane] = v[1];
  z[lane] = v[2];
}
} // namespace

TOWFORM_VECTOR_CLONES
void differentiate(const Patches& p, const Padded* __restrict field, int nodes, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    Vec4 warp{}, weft{};
    const YarnPair* weight = p.weight + p.weights_of[n];
    for (int t = p.first[n]; t < p.first[n + 1]; ++t, ++weight) {
      const Vec4 at = field[p.point[t]].v;
      warp += weight->warp * at;
      weft += weight->weft * at;
    }
    put(warp, n, l.warp_x, l.warp_y, l.warp_z);
    put(weft, n, l.weft_x, l.weft_y, l.weft_z);
  }
}

TOWFORM_VECTOR_CLONES
void draw_chords(const std::array<std::uint16_t, 4>* ends, const Padded* __restrict position, int nodes, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    const auto [a0, a1, b0, b1] = ends[n];
    const Vec4 a = position[a1].v - position[a0].v, b = position[b1].v - position[b0].v;
    put(a, n, l.ax, l.ay, l.az);
    put(b, n, l.bx, l.by, l.bz);
  }
}

TOWFORM_VECTOR_CLONES
void spread_moments(const Patches& p, const BendingLanes& __restrict l, int nodes, Padded* __restrict force)
{
  for (int n = 0; n < nodes; ++n) {
    const Vec4 normal{l.nx[n], l.ny[n], l.nz[n], 0.0};
    const Vec4 warp = l.warp_moment[n] * normal, weft = l.weft_moment[n] * normal;
    const YarnPair* weight = p.weight + p.weights_of[n];
    for (int t = p.first[n]; t < p.first[n + 1]; ++t, ++weight)
      force[p.point[t]].v -= weight->warp * warp + weight->weft * weft;
  }
}

TOWFORM_VECTOR_CLONES
void spread_chords(const std::array<std::uint16_t, 4>* ends, const BendingLanes& __restrict l, int nodes, Padded* __restrict force)
{
  for (int n = 0; n < nodes; ++n) {
    const auto [a0, a1, b0, b1] = ends[n];
    const Vec4 on_a{l.on_ax[n], l.on_ay[n], l.on_az[n], 0.0}, on_b{l.on_bx[n], l.on_by[n], l.on_bz[n], 0.0};
    force[a0].v += on_a;
    force[a1].v -= on_a;
    force[b0].v += on_b;
    force[b1].v -= on_b;
  }
}

TOWFORM_VECTOR_CLONES
void find_normals(int nodes, BendingLanes& __restrict l)
{
  constexpr double least = 1e-200; // [m^4]; lanes between the nodes may have no chords
  for (int n = 0; n < nodes; ++n) {
    const double cx = l.ay[n] * l.bz[n] - l.az[n] * l.by[n], cy = l.az[n] * l.bx[n] - l.ax[n] * l.bz[n],
                 cz = l.ax[n] * l.by[n] - l.ay[n] * l.bx[n];
    const double square = cx * cx + cy * cy + cz * cz;
    const double inverse = 1.0 / std::sqrt(square > least ? square : least);
    l.inverse[n] = inverse;
    l.nx[n] = inverse * cx;
    l.ny[n] = inverse * cy;
    l.nz[n] = inverse * cz;
  }
}

TOWFORM_VECTOR_CLONES
void find_curvatures(int nodes, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    l.warp_now[n] = l.nx[n] * l.warp_x[n] + l.ny[n] * l.warp_y[n] + l.nz[n] * l.warp_z[n];
    l.weft_now[n] = l.nx[n] * l.weft_x[n] + l.ny[n] * l.weft_y[n] + l.nz[n] * l.weft_z[n];
  }
}

TOWFORM_VECTOR_CLONES
void turn(int nodes, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    const double warp = l.inverse[n] * l.warp_moment[n], weft = l.inverse[n] * l.weft_moment[n];
    const double along = warp * l.warp_now[n] + weft * l.weft_now[n];
    const double tx = warp * l.warp_x[n] + weft * l.weft_x[n] - along * l.nx[n];
    const double ty = warp * l.warp_y[n] + weft * l.weft_y[n] - along * l.ny[n];
    const double tz = warp * l.warp_z[n] + weft * l.weft_z[n] - along * l.nz[n];
    l.on_ax[n] = l.by[n] * tz - l.bz[n] * ty;
    l.on_ay[n] = l.bz[n] * tx - l.bx[n] * tz;
    l.on_az[n] = l.bx[n] * ty - l.by[n] * tx;
    l.on_bx[n] = ty * l.az[n] - tz * l.ay[n];
    l.on_by[n] = tz * l.ax[n] - tx * l.az[n];
    l.on_bz[n] = tx * l.ay[n] - ty * l.ax[n];
  }
}

TOWFORM_VECTOR_CLONES
void bend(const StraightMoments& moments, const double* areas, YarnPair* curvatures, int nodes, BendingLanes& __restrict l)
{
  const StraightMoments m = moments;
  const double* __restrict area = areas;
  YarnPair* __restrict curvature = curvatures;
  for (int n = 0; n < nodes; ++n) {
    const double warp = l.warp_now[n] - curvature[n].warp, weft = l.weft_now[n] - curvature[n].weft; // changes
    l.warp_moment[n] = area[n] * (m.stiffness.warp * (l.warp_now[n] + m.ahead * warp) + m.viscosity.warp * warp);
    l.weft_moment[n] = area[n] * (m.stiffness.weft * (l.weft_now[n] + m.ahead * weft) + m.viscosity.weft * weft);
    l.lost[n] = area[n] * (m.viscosity.warp * warp * warp + m.viscosity.weft * weft * weft);
    curvature[n].warp = l.warp_now[n];
    curvature[n].weft = l.weft_now[n];
  }
}

TOWFORM_VECTOR_CLONES
void bend(const YarnPair& stiffness, const double* areas, int nodes, BendingLanes& __restrict l)
{
  const YarnPair s = stiffness;
  const double* __restrict area = areas;
  for (int n = 0; n < nodes; ++n) {
    l.warp_moment[n] = area[n] * (s.warp * l.warp_now[n]);
    l.weft_moment[n] = area[n] * (s.weft * l.weft_now[n]);
  }
}

} // namespace towform
