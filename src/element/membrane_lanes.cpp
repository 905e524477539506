#include "element/membrane_lanes.hpp"
#include "element/arcsine.hpp"
#include "parallel/vector_clones.hpp"
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace towform {

namespace {
/// The part of a motion's yarn vector g_1 d1 + g_2 d2 along (x, y, z).
inline double along(double x, double y, double z, double g_1, double g_2, const MembraneBatch& b, int i)
{
  return x * (g_1 * b.d1x[i] + g_2 * b.d2x[i]) + y * (g_1 * b.d1y[i] + g_2 * b.d2y[i]) +
         z * (g_1 * b.d1z[i] + g_2 * b.d2z[i]);
}

/// Force along an entry's yarn: tension times the reference area.
inline double pull_of(const BlockLanes& lanes, double area, double spring, int entry)
{
  return area * lanes.base_tension[entry] + spring * lanes.weighed_strain[entry];
}
} // namespace

namespace {
/// 1/sqrt(1 + d), d up to 1/64 in size, by its binomial series: 1e-17 off. In pairs, as sums that wait for each other fill the
/// processor's queue.
inline double inverse_root_near_one(double d)
{
  const double d2 = d * d, d4 = d2 * d2;
  const double low = (1.0 - 0.5 * d) + d2 * (0.375 - 0.3125 * d);
  const double high = (0.2734375 - 0.24609375 * d) + d2 * (0.2255859375 - 0.20947265625 * d);
  return low + d4 * (high + d4 * 0.196380615234375);
}
constexpr double near_one = 1.0 / 64.0;

/// A yarn before it is made a unit vector.
struct Yarn {
  double x, y, z, square;
};
inline Yarn yarn(double g_1, double g_2, const MembraneBatch& b, int i)
{
  const double x = g_1 * b.d1x[i] + g_2 * b.d2x[i], y = g_1 * b.d1y[i] + g_2 * b.d2y[i], z = g_1 * b.d1z[i] + g_2 * b.d2z[i];
  return {x, y, z, x * x + y * y + z * z};
}
inline void put_yarns(const Yarn& warp, double over_warp, const Yarn& weft, double over_weft, double area, int k,
                      BlockLanes& __restrict lanes)
{
  lanes.weighed_strain[k] = area * (warp.square * over_warp - 1.0);
  lanes.weighed_strain[BlockLanes::size + k] = area * (weft.square * over_weft - 1.0);
  lanes.over_stretch[k] = over_warp;
  lanes.over_stretch[BlockLanes::size + k] = over_weft;
  lanes.f1x[k] = over_warp * warp.x;
  lanes.f1y[k] = over_warp * warp.y;
  lanes.f1z[k] = over_warp * warp.z;
  lanes.f2x[k] = over_weft * weft.x;
  lanes.f2y[k] = over_weft * weft.y;
  lanes.f2z[k] = over_weft * weft.z;
}
} // namespace

TOWFORM_VECTOR_CLONES
void yarn_vectors(const MembraneCoefficients& c, const MembraneBatch& __restrict b, int first, int count,
                  BlockLanes& __restrict lanes)
{
  const MembraneCoefficients g = c;
  std::int64_t far = 0;
  for (int i = 0; i < count; ++i) { // roots and divisions take longest, and yarns hardly stretch
    const Yarn warp = yarn(g.warp_1[i], g.warp_2[i], b, i), weft = yarn(g.weft_1[i], g.weft_2[i], b, i);
    const double d1 = warp.square - 1.0, d2 = weft.square - 1.0;
    put_yarns(warp, inverse_root_near_one(d1), weft, inverse_root_near_one(d2), g.area[i], first + i, lanes);
    far += (std::abs(d1) > near_one ? 1 : 0) | (std::abs(d2) > near_one ? 1 : 0);
  }
  if (far == 0) return;
  for (int i = 0; i < count; ++i) {
    const Yarn warp = yarn(g.warp_1[i], g.warp_2[i], b, i), weft = yarn(g.weft_1[i], g.weft_2[i], b, i);
    const double stretch1 = std::sqrt(warp.square), stretch2 = std::sqrt(weft.square), over_both = 1.0 / (stretch1 * stretch2);
    put_yarns(warp, stretch2 * over_both, weft, stretch1 * over_both, g.area[i], first + i, lanes);
  }
}

TOWFORM_VECTOR_CLONES
void shear_angles(const BlockLanes& __restrict lanes, int first, int count, double reference_angle, MembraneBatch& __restrict b)
{
  std::int64_t steep = 0;
  for (int i = 0; i < count; ++i) {
    const double dot = lanes.f1x[first + i] * lanes.f2x[first + i] + lanes.f1y[first + i] * lanes.f2y[first + i] +
                       lanes.f1z[first + i] * lanes.f2z[first + i];
    const double below = dot > 1.0 ? 1.0 : dot;
    const double sine = below < -1.0 ? -1.0 : below;
    b.sine[i] = sine;
    steep += std::abs(sine) > 0.5 ? 1 : 0;
  }
  if (steep == 0) // of most batches: quicker
    for (int i = 0; i < count; ++i) b.angle[i] = arcsine_to_half(b.sine[i]) - reference_angle;
  else
    for (int i = 0; i < count; ++i) b.angle[i] = arcsine(b.sine[i]) - reference_angle;
}

TOWFORM_VECTOR_CLONES
void keep(const double* area, double dt, int count, MembraneBatch& __restrict b, const ShearLanes& state)
{
  const double* __restrict areas = area;
  double* __restrict sine = state.sine;
  double* __restrict angle = state.angle;
  double* __restrict force = state.force;
  double* __restrict rate = state.rate;
  for (int i = 0; i < count; ++i) {
    b.work[i] = areas[i] * 0.5 * (force[i] + b.force[i]) * (b.sine[i] - sine[i]);
    b.dissipated[i] = areas[i] * b.lost[i] * dt * std::sqrt(1.0 - b.sine[i] * b.sine[i]);
    sine[i] = b.sine[i];
    angle[i] = b.angle[i];
    force[i] = b.force[i];
    rate[i] = b.rate[i];
  }
}

TOWFORM_VECTOR_CLONES
double sum(const double* values, int count)
{
  constexpr int side_by_side = 8;
  alignas(64) std::array<double, side_by_side> sums{};
  int i = 0;
  for (; i + side_by_side <= count; i += side_by_side)
    for (int k = 0; k < side_by_side; ++k) sums[k] += values[i + k];
  for (int k = 0; i < count; ++i, ++k) sums[k] += values[i];
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

TOWFORM_VECTOR_CLONES
void shear_and_tension(const MembraneCoefficients& c, double spring, const BlockLanes& __restrict lanes, int first,
                       int count, MembraneBatch& __restrict b)
{
  const MembraneCoefficients g = c;
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const double area = g.area[i], sine = b.sine[i], force = b.force[i];
    const double n1 = force * lanes.over_stretch[k], n2 = force * lanes.over_stretch[BlockLanes::size + k];
    // P . f01 and P . f02 times the area
    const double across1 = area * n1, along1 = pull_of(lanes, area, spring, k) - across1 * sine;
    const double across2 = area * n2, along2 = pull_of(lanes, area, spring, BlockLanes::size + k) - across2 * sine;
    const double t1x = along1 * lanes.f1x[k] + across1 * lanes.f2x[k];
    const double t1y = along1 * lanes.f1y[k] + across1 * lanes.f2y[k];
    const double t1z = along1 * lanes.f1z[k] + across1 * lanes.f2z[k];
    const double t2x = along2 * lanes.f2x[k] + across2 * lanes.f1x[k];
    const double t2y = along2 * lanes.f2y[k] + across2 * lanes.f1y[k];
    const double t2z = along2 * lanes.f2z[k] + across2 * lanes.f1z[k];
    b.p1x[i] = -g.warp_1[i] * t1x - g.weft_1[i] * t2x;
    b.p1y[i] = -g.warp_1[i] * t1y - g.weft_1[i] * t2y;
    b.p1z[i] = -g.warp_1[i] * t1z - g.weft_1[i] * t2z;
    b.p2x[i] = -g.warp_2[i] * t1x - g.weft_2[i] * t2x;
    b.p2y[i] = -g.warp_2[i] * t1y - g.weft_2[i] * t2y;
    b.p2z[i] = -g.warp_2[i] * t1z - g.weft_2[i] * t2z;
  }
}

TOWFORM_VECTOR_CLONES
void tension(const MembraneCoefficients& c, double spring, const BlockLanes& __restrict lanes, int first, int count,
             MembraneBatch& __restrict b)
{
  const MembraneCoefficients g = c;
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const double warp = pull_of(lanes, g.area[i], spring, k);
    const double weft = pull_of(lanes, g.area[i], spring, BlockLanes::size + k);
    const double warp1 = -warp * g.warp_1[i], warp2 = -warp * g.warp_2[i];
    const double weft1 = -weft * g.weft_1[i], weft2 = -weft * g.weft_2[i];
    b.p1x[i] = warp1 * lanes.f1x[k] + weft1 * lanes.f2x[k];
    b.p1y[i] = warp1 * lanes.f1y[k] + weft1 * lanes.f2y[k];
    b.p1z[i] = warp1 * lanes.f1z[k] + weft1 * lanes.f2z[k];
    b.p2x[i] = warp2 * lanes.f1x[k] + weft2 * lanes.f2x[k];
    b.p2y[i] = warp2 * lanes.f1y[k] + weft2 * lanes.f2y[k];
    b.p2z[i] = warp2 * lanes.f1z[k] + weft2 * lanes.f2z[k];
  }
}

TOWFORM_VECTOR_CLONES
void strip_tensions(const YarnLaw& law, double viscosity, double spring, const double* area, double* strain, int count,
                    StripLanes& __restrict s)
{
  const YarnLaw yarn = law;
  double* __restrict old_strain = strain;
  const double* __restrict areas = area;
  for (int i = 0; i < count; ++i) {
    const double mean = s.sum[i] / areas[i], change = mean - old_strain[i];
    const double damping = viscosity * change;
    s.base_tension[i] = yarn.tension(mean) + damping - spring * mean;
    s.lost[i] = areas[i] * damping * change;
    old_strain[i] = mean;
  }
}

void sum_strips(const StripEntries& s, const BlockLanes& lanes, StripLanes& strips)
{
  for (int i = 0; i < s.count; ++i) {
    double strain = 0.0;
    TOWFORM_UNROLLED
    for (int k = s.first[i]; k < s.first[i + 1]; ++k) strain += lanes.weighed_strain[s.entry[k]];
    strips.sum[i] = strain;
  }
}

void hand_out(const StripEntries& s, const StripLanes& strips, BlockLanes& lanes)
{
  for (int i = 0; i < s.count; ++i) {
    const double tension = strips.base_tension[i];
    TOWFORM_UNROLLED
    for (int k = s.first[i]; k < s.first[i + 1]; ++k) lanes.base_tension[s.entry[k]] = tension;
  }
}

void leave_out(std::span<const ElementBlocks::Entry> entries, BlockLanes& lanes)
{
  for (const ElementBlocks::Entry entry : entries) lanes.base_tension[entry] = lanes.weighed_strain[entry] = 0.0;
}

TOWFORM_VECTOR_CLONES
void motion_strains(const MembraneCoefficients& c, const MembraneBatch& __restrict b, int first, int count,
                    BlockLanes& __restrict lanes)
{
  const MembraneCoefficients g = c;
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const double warp = along(lanes.f1x[k], lanes.f1y[k], lanes.f1z[k], g.warp_1[i], g.warp_2[i], b, i);
    const double weft = along(lanes.f2x[k], lanes.f2y[k], lanes.f2z[k], g.weft_1[i], g.weft_2[i], b, i);
    lanes.weighed_strain[k] = g.area[i] * warp;
    lanes.weighed_strain[BlockLanes::size + k] = g.area[i] * weft;
  }
}

/// d sin(theta) = (f2 - sin f1) . da1 / lambda1 + (f1 - sin f2) . da2 / lambda2
TOWFORM_VECTOR_CLONES
void motion_shear(const MembraneCoefficients& c, double modulus, const BlockLanes& __restrict lanes, int first, int count,
                  MembraneBatch& __restrict b)
{
  const MembraneCoefficients g = c;
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const double sine = b.sine[i];
    const double along1 = along(lanes.f1x[k], lanes.f1y[k], lanes.f1z[k], g.warp_1[i], g.warp_2[i], b, i);
    const double along2 = along(lanes.f2x[k], lanes.f2y[k], lanes.f2z[k], g.weft_1[i], g.weft_2[i], b, i);
    const double across1 = along(lanes.f2x[k], lanes.f2y[k], lanes.f2z[k], g.warp_1[i], g.warp_2[i], b, i);
    const double across2 = along(lanes.f1x[k], lanes.f1y[k], lanes.f1z[k], g.weft_1[i], g.weft_2[i], b, i);
    const double turned = lanes.over_stretch[k] * (across1 - sine * along1) +
                          lanes.over_stretch[BlockLanes::size + k] * (across2 - sine * along2);
    constexpr double least_square = 1e-12; // of the cosine
    const double square = 1.0 - sine * sine;
    b.force[i] = modulus * turned / std::sqrt(square > least_square ? square : least_square);
  }
}

namespace {
/// The numbers of four vectors side by side.
struct Columns {
  Vec4 x, y, z;
};
inline Columns columns(const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d)
{
  const Vec4 xz_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), y_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Vec4 xz_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6), y_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(xz_ab, xz_cd, 0, 1, 4, 5), __builtin_shufflevector(y_ab, y_cd, 0, 1, 4, 5),
          __builtin_shufflevector(xz_ab, xz_cd, 2, 3, 6, 7)};
}
inline void put(const Columns& c, double* x, double* y, double* z)
{
  std::memcpy(x, &c.x, sizeof c.x);
  std::memcpy(y, &c.y, sizeof c.y);
  std::memcpy(z, &c.z, sizeof c.z);
}

/// Four vectors whose numbers lie side by side.
struct Rows {
  Vec4 a, b, c, d;
};
inline Rows rows(const double* its_x, const double* its_y, const double* its_z)
{
  Vec4 x, y, z;
  std::memcpy(&x, its_x, sizeof x);
  std::memcpy(&y, its_y, sizeof y);
  std::memcpy(&z, its_z, sizeof z);
  const Vec4 none{};
  const Vec4 xy_ac = __builtin_shufflevector(x, y, 0, 4, 2, 6), xy_bd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  const Vec4 z_ac = __builtin_shufflevector(z, none, 0, 4, 2, 6), z_bd = __builtin_shufflevector(z, none, 1, 5, 3, 7);
  return {__builtin_shufflevector(xy_ac, z_ac, 0, 1, 4, 5), __builtin_shufflevector(xy_bd, z_bd, 0, 1, 4, 5),
          __builtin_shufflevector(xy_ac, z_ac, 2, 3, 6, 7), __builtin_shufflevector(xy_bd, z_bd, 2, 3, 6, 7)};
}

/// Edges from corner 0.
struct Edges {
  Vec4 d1, d2;
};
inline Edges edges(const Padded* position, const std::uint16_t* corner)
{
  const Vec4 x0 = position[corner[0]].v;
  return {position[corner[1]].v - x0, position[corner[2]].v - x0};
}

/// An element's forces on its corners 1 and 2; what is left is on corner 0.
inline void add(const Vec4& force_1, const Vec4& force_2, const std::uint16_t* corner, Padded* force)
{
  force[corner[0]].v -= force_1 + force_2;
  force[corner[1]].v += force_1;
  force[corner[2]].v += force_2;
}

} // namespace

TOWFORM_VECTOR_CLONES
void gather_edges(const Padded* position, const std::uint16_t* corner, int count, MembraneBatch& __restrict b)
{
  int i = 0;
  for (; i + 4 <= count; i += 4, corner += 12) {
    const Edges e0 = edges(position, corner), e1 = edges(position, corner + 3), e2 = edges(position, corner + 6),
                e3 = edges(position, corner + 9);
    put(columns(e0.d1, e1.d1, e2.d1, e3.d1), b.d1x + i, b.d1y + i, b.d1z + i);
    put(columns(e0.d2, e1.d2, e2.d2, e3.d2), b.d2x + i, b.d2y + i, b.d2z + i);
  }
  for (; i < count; ++i, corner += 3) {
    const auto [d1, d2] = edges(position, corner);
    b.d1x[i] = d1[0];
    b.d1y[i] = d1[1];
    b.d1z[i] = d1[2];
    b.d2x[i] = d2[0];
    b.d2y[i] = d2[1];
    b.d2z[i] = d2[2];
  }
}

TOWFORM_VECTOR_CLONES
void add_forces(const MembraneBatch& __restrict b, const std::uint16_t* corner, int count, Padded* __restrict force)
{
  int i = 0;
  for (; i + 4 <= count; i += 4, corner += 12) {
    const Rows on_1 = rows(b.p1x + i, b.p1y + i, b.p1z + i), on_2 = rows(b.p2x + i, b.p2y + i, b.p2z + i);
    add(on_1.a, on_2.a, corner, force);
    add(on_1.b, on_2.b, corner + 3, force);
    add(on_1.c, on_2.c, corner + 6, force);
    add(on_1.d, on_2.d, corner + 9, force);
  }
  for (; i < count; ++i, corner += 3)
    add(Vec4{b.p1x[i], b.p1y[i], b.p1z[i], 0.0}, Vec4{b.p2x[i], b.p2y[i], b.p2z[i], 0.0}, corner, force);
}

} // namespace towform
