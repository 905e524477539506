#include "contact/contact_lanes.hpp"
#include "parallel/vector_clones.hpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace towform {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

TOWFORM_VECTOR_CLONES
void split(const Vec3* from, int count, double* x, double* y, double* z)
{
  const double* __restrict in_a_row = &from->x;
  double* __restrict to_x = x;
  double* __restrict to_y = y;
  double* __restrict to_z = z;
  for (int i = 0; i < count; ++i) {
    to_x[i] = in_a_row[3 * i];
    to_y[i] = in_a_row[3 * i + 1];
    to_z[i] = in_a_row[3 * i + 2];
  }
}

TOWFORM_VECTOR_CLONES
void add(const double* x, const double* y, const double* z, int count, Vec3* to)
{
  const double* __restrict from_x = x;
  const double* __restrict from_y = y;
  const double* __restrict from_z = z;
  double* __restrict in_a_row = &to->x;
  for (int i = 0; i < count; ++i) {
    in_a_row[3 * i] += from_x[i];
    in_a_row[3 * i + 1] += from_y[i];
    in_a_row[3 * i + 2] += from_z[i];
  }
}

TOWFORM_VECTOR_CLONES
int look(const NodeLanes& nodes, const ContactLanes& c, const Vec3& shift, int count, std::int32_t* marks)
{
  const float* __restrict anchor_x = c.anchor_x;
  const float* __restrict anchor_y = c.anchor_y;
  const float* __restrict anchor_z = c.anchor_z;
  const float* __restrict reach_squared = c.reach_squared;
  std::int32_t* __restrict mark = marks;
  const double shift_x = shift.x, shift_y = shift.y, shift_z = shift.z;
  std::int32_t marked = 0;
  for (int i = 0; i < count; ++i) {
    const float dx = static_cast<float>(nodes.x[i] - shift_x) - anchor_x[i],
                dy = static_cast<float>(nodes.y[i] - shift_y) - anchor_y[i],
                dz = static_cast<float>(nodes.z[i] - shift_z) - anchor_z[i];
    const std::int32_t out = dx * dx + dy * dy + dz * dz <= reach_squared[i] ? 0 : 1;
    mark[i] = out;
    marked += out;
  }
  return marked;
}

TOWFORM_VECTOR_CLONES
double least_room(const NodeLanes& nodes, const ContactLanes& c, const Vec3& shift, int count)
{
  const float* __restrict anchor_x = c.anchor_x;
  const float* __restrict anchor_y = c.anchor_y;
  const float* __restrict anchor_z = c.anchor_z;
  const float* __restrict reach_squared = c.reach_squared;
  const double shift_x = shift.x, shift_y = shift.y, shift_z = shift.z;
  std::int32_t least = std::bit_cast<std::int32_t>(HUGE_VALF); // the bits of numbers that are not negative stand in their order
  for (int i = 0; i < count; ++i) {
    const float dx = static_cast<float>(nodes.x[i] - shift_x) - anchor_x[i],
                dy = static_cast<float>(nodes.y[i] - shift_y) - anchor_y[i],
                dz = static_cast<float>(nodes.z[i] - shift_z) - anchor_z[i];
    const float reach = std::sqrt(reach_squared[i] > 0.0F ? reach_squared[i] : 0.0F);
    const float room = reach - std::sqrt(dx * dx + dy * dy + dz * dz);
    const auto bits = std::bit_cast<std::int32_t>(room > 0.0F ? room : 0.0F);
    least = bits < least ? bits : least;
  }
  constexpr double rounding = 1e-5; // [m] of single precision, for places up to 10 m from the origin
  return static_cast<double>(std::bit_cast<float>(least)) * (1.0 - 1e-6) - rounding;
}

namespace {
constexpr int group = NodeLanes::group;

/// The least of a group.
inline double least(const double* v)
{
  static_assert(group == 8);
  const auto of_two = [](double a, double b) { return a < b ? a : b; };
  double four[4]; // NOLINT(modernize-avoid-c-arrays)
  for (int k = 0; k < 4; ++k) four[k] = of_two(v[k], v[k + 4]);
  return of_two(of_two(four[0], four[2]), of_two(four[1], four[3]));
}

/// Measures group g; returns the least of its gaps.
inline double measure_group(const NodeLanes& nodes, const ContactLanes& c, const ContactLaw& l, int g, GapLanes& __restrict gaps)
{
  const double* __restrict normal_x = c.normal_x;
  const double* __restrict normal_y = c.normal_y;
  const double* __restrict normal_z = c.normal_z;
  const double* __restrict offset = c.offset;
  const int first = g * group;
  TOWFORM_WHOLE
  for (int k = 0; k < group; ++k) {
    const int i = first + k;
    const double px = nodes.x[i] - l.shift.x, py = nodes.y[i] - l.shift.y, pz = nodes.z[i] - l.shift.z;
    gaps.gap[i] = (normal_x[i] * px + normal_y[i] * py + normal_z[i] * pz - offset[i]) - l.half_thickness;
  }
  return gaps.least[g] = least(gaps.gap + first);
}

} // namespace

TOWFORM_VECTOR_CLONES
bool measure(const NodeLanes& nodes, const ContactLanes& c, const ContactLaw& law, const std::uint8_t* groups, int count,
             GapLanes& __restrict gaps)
{
  const ContactLaw l = law;
  bool deep = false;
  for (int number = 0; number < count; ++number)
    if (measure_group(nodes, c, l, groups[number], gaps) < -l.half_thickness) deep = true;
  return deep;
}

namespace {

/// Depth of a linear spring of the full stiffness that presses as much.
inline double compressed(const ContactLaw& l, double depth)
{
  const double soft = l.soft * depth, stiff = depth - (1.0 - l.soft) * l.soft_depth;
  return soft > stiff ? soft : stiff;
}

} // namespace

TOWFORM_VECTOR_CLONES
int press(NodeLanes& __restrict nodes, const ContactLanes& c, const ContactLaw& law, const std::uint8_t* __restrict groups,
          int from, int count, bool searched, GapLanes& __restrict gaps, PressLanes& __restrict sums)
{
  const double* __restrict normal_x = c.normal_x;
  const double* __restrict normal_y = c.normal_y;
  const double* __restrict normal_z = c.normal_z;
  double* __restrict stick_x = c.stick_x;
  double* __restrict stick_y = c.stick_y;
  double* __restrict stick_z = c.stick_z;
  double* __restrict normal_force = c.normal_force;
  std::uint8_t* __restrict touching = c.touching;
  const ContactLaw l = law;
  PressLanes s = sums;
  int number = from;
  for (; number < count; ++number) {
    const int g = groups[number], first = g * group;
    const double least_gap = measure_group(nodes, c, l, g, gaps);
    if (least_gap < -l.half_thickness && !(searched && number == from)) break;
    touching[g] = least_gap < 0.0 ? 1 : 0;
    TOWFORM_INDEPENDENT
    for (int k = 0; k < group; ++k) {
      const int i = first + k;
      const double nx = normal_x[i], ny = normal_y[i], nz = normal_z[i], gap = gaps.gap[i];
      const double vx = nodes.vx[i] - l.velocity.x, vy = nodes.vy[i] - l.velocity.y, vz = nodes.vz[i] - l.velocity.z;
      const double stiffness = l.stiffness_per_area * nodes.area[i], damping = l.damping_per_area * nodes.area[i];
      const double opening = vx * nx + vy * ny + vz * nz;
      const double linear = compressed(l, -gap);
      const double wanted = stiffness * linear - damping * opening;
      const double pressed = wanted > 0.0 ? wanted : 0.0;

      // As if the node stuck:
      const double tx = l.dt * (vx - opening * nx), ty = l.dt * (vy - opening * ny), tz = l.dt * (vz - opening * nz);
      const double lift = stick_x[i] * nx + stick_y[i] * ny + stick_z[i] * nz;
      const double rx = stick_x[i] - lift * nx + tx, ry = stick_y[i] - lift * ny + ty, rz = stick_z[i] - lift * nz + tz;
      const double spring = l.stick_ratio * stiffness, limit = l.friction * pressed;
      const double stretch_squared = rx * rx + ry * ry + rz * rz;
      const bool slips = spring * spring * stretch_squared > limit * limit;
      const double dashpot = slips ? 0.0 : l.stick_ratio * l.damping_per_area / l.dt * nodes.area[i];
      const double hx = spring * rx + dashpot * tx, hy = spring * ry + dashpot * ty, hz = spring * rz + dashpot * tz;
      const double size_squared = hx * hx + hy * hy + hz * hz; // slipping, that of the spring alone

      // Back to the cone:
      const bool cut = size_squared > limit * limit;
      const double share = cut ? limit / std::sqrt(cut ? size_squared : 1.0) : 1.0;
      const double gx = -share * hx, gy = -share * hy, gz = -share * hz;
      const double kept = slips ? share : 1.0;
      const double sx = kept * rx, sy = kept * ry, sz = kept * rz;
      const double by_slip = spring * kept * (1.0 - kept) * stretch_squared;
      const double by_dashpot = -((gx + spring * sx) * tx + (gy + spring * sy) * ty + (gz + spring * sz) * tz);

      const bool on = gap < 0.0;
      const double fx = on ? pressed * nx + gx : 0.0, fy = on ? pressed * ny + gy : 0.0,
                   fz = on ? pressed * nz + gz : 0.0;
      const double was_pressed = normal_force[i];
      stick_x[i] = on ? sx : 0.0;
      stick_y[i] = on ? sy : 0.0;
      stick_z[i] = on ? sz : 0.0;
      normal_force[i] = on ? pressed : 0.0;
      nodes.fx[i] += fx;
      nodes.fy[i] += fy;
      nodes.fz[i] += fz;
      s.fx[k] += fx;
      s.fy[k] += fy;
      s.fz[k] += fz;
      const double at_joint = l.soft * l.soft_depth;
      const double squared = linear * linear + (linear < at_joint ? linear : at_joint) * (-gap - linear);
      const double stored = 0.5 * stiffness * squared + 0.5 * spring * (sx * sx + sy * sy + sz * sz);
      s.elastic[k] += on ? stored : 0.0;
      const double was = compressed(l, opening * l.dt - gap), was_linear = was > 0.0 ? was : 0.0; // a step ago
      const double of_damping = (on ? stiffness * linear - pressed : 0.0) + (stiffness * was_linear - was_pressed);
      s.damped[k] += 0.5 * of_damping * opening * l.dt;
      s.rubbed[k] += on ? (slips ? by_slip : by_dashpot) : 0.0;
      const double along = nx * l.direction.x + ny * l.direction.y + nz * l.direction.z;
      s.stiffness[k] += on ? stiffness * along * along : 0.0;
      const double depth = on ? -gap : 0.0;
      s.depth[k] = s.depth[k] < depth ? depth : s.depth[k];
    }
  }
  sums = s;
  return number;
}

namespace {
double sum(const double* v) { return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7])); }
} // namespace

ContactSums total(const PressLanes& s)
{
  return {{sum(s.fx), sum(s.fy), sum(s.fz)}, sum(s.elastic), sum(s.damped), sum(s.rubbed), sum(s.stiffness),
          *std::max_element(s.depth, s.depth + group)};
}

} // namespace towform
