#include "contact/contact_lanes.hpp"
#include "parallel/vector_clones.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

TOWFORM_VECTOR_CLONES
Awake look(const NodeLanes& nodes, const ContactLanes& c, const ContactLaw& law, int count, long long* marks)
{
  const double* __restrict anchor_x = c.anchor_x;
  const double* __restrict anchor_y = c.anchor_y;
  const double* __restrict anchor_z = c.anchor_z;
  const double* __restrict reach_squared = c.reach_squared;
  const double* __restrict offset = c.offset;
  const double shift_x = law.shift.x, shift_y = law.shift.y, shift_z = law.shift.z;
  long long marked = 0, near = 0;
  for (int i = 0; i < count; ++i) {
    const double dx = (nodes.x[i] - shift_x) - anchor_x[i], dy = (nodes.y[i] - shift_y) - anchor_y[i],
                 dz = (nodes.z[i] - shift_z) - anchor_z[i];
    const long long out = dx * dx + dy * dy + dz * dz <= reach_squared[i] ? 0 : 1;
    marks[i] = out;
    marked += out;
    near += offset[i] > no_plane ? 1 : 0;
  }
  return {static_cast<int>(marked), static_cast<int>(near)};
}

namespace {

constexpr int side_by_side = 8; ///< sums are kept in so many parts, whatever the vectors' width

struct PushLanes {
  alignas(64) double depth[NodeLanes::size], elastic[NodeLanes::size]; // NOLINT(modernize-avoid-c-arrays)
  alignas(64) double damped[NodeLanes::size], rubbed[NodeLanes::size]; // NOLINT(modernize-avoid-c-arrays)
  alignas(64) double gx[NodeLanes::size], gy[NodeLanes::size], gz[NodeLanes::size]; // NOLINT(modernize-avoid-c-arrays)
};

TOWFORM_VECTOR_CLONES
void push_lanes(NodeLanes& __restrict nodes, const ContactLanes& c, const double* __restrict mass,
                const ContactLaw& law, int count, PushLanes& __restrict out)
{
  const double* __restrict normal_x = c.normal_x;
  const double* __restrict normal_y = c.normal_y;
  const double* __restrict normal_z = c.normal_z;
  const double* __restrict offset = c.offset;
  double* __restrict stick_x = c.stick_x;
  double* __restrict stick_y = c.stick_y;
  double* __restrict stick_z = c.stick_z;
  double* __restrict normal_force = c.normal_force;
  const ContactLaw l = law;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double nx = normal_x[i], ny = normal_y[i], nz = normal_z[i];
    const double px = nodes.x[i] - l.shift.x, py = nodes.y[i] - l.shift.y, pz = nodes.z[i] - l.shift.z;
    const double gap = (nx * px + ny * py + nz * pz - offset[i]) - l.half_thickness;

    const double vx = nodes.vx[i] - l.velocity.x, vy = nodes.vy[i] - l.velocity.y, vz = nodes.vz[i] - l.velocity.z;
    const double stiffness = l.stiffness_per_mass * mass[i], damping = l.damping_per_mass * mass[i];
    const double opening = vx * nx + vy * ny + vz * nz;
    const double elastic = -stiffness * gap, wanted = elastic - damping * opening;
    const double pressed = wanted > 0.0 ? wanted : 0.0;

    const double tx = l.dt * (vx - opening * nx), ty = l.dt * (vy - opening * ny), tz = l.dt * (vz - opening * nz);
    const double lift = stick_x[i] * nx + stick_y[i] * ny + stick_z[i] * nz;
    const double rx = stick_x[i] - lift * nx + tx, ry = stick_y[i] - lift * ny + ty,
                 rz = stick_z[i] - lift * nz + tz;
    const double spring = l.stick_ratio * stiffness, limit = l.friction * pressed;
    const double stretch_squared = rx * rx + ry * ry + rz * rz, pull_squared = spring * spring * stretch_squared;
    const bool slips = pull_squared > limit * limit;
    const double dashpot = slips ? 0.0 : l.damping_per_mass / l.dt * mass[i];
    const double hx = spring * rx + dashpot * tx, hy = spring * ry + dashpot * ty, hz = spring * rz + dashpot * tz;
    const double size_squared = hx * hx + hy * hy + hz * hz; // slipping, that of the spring alone
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
    stick_x[i] = on ? sx : 0.0;
    stick_y[i] = on ? sy : 0.0;
    stick_z[i] = on ? sz : 0.0;
    normal_force[i] = on ? pressed : 0.0;
    nodes.fx[i] += fx;
    nodes.fy[i] += fy;
    nodes.fz[i] += fz;
    out.gx[i] = fx;
    out.gy[i] = fy;
    out.gz[i] = fz;
    out.depth[i] = on ? -gap : 0.0;
    const double stored = 0.5 * stiffness * gap * gap + 0.5 * spring * (sx * sx + sy * sy + sz * sz);
    out.elastic[i] = on ? stored : 0.0;
    out.damped[i] = on ? (elastic - pressed) * opening * l.dt : 0.0;
    out.rubbed[i] = on ? (slips ? by_slip : by_dashpot) : 0.0;
  }
}

/// Sums of a block's lanes, eight side by side.
struct SideBySide {
  alignas(64) double fx[side_by_side]{}, fy[side_by_side]{}, fz[side_by_side]{}; // NOLINT(modernize-avoid-c-arrays)
  alignas(64) double elastic[side_by_side]{}, damped[side_by_side]{};            // NOLINT(modernize-avoid-c-arrays)
  alignas(64) double rubbed[side_by_side]{}, depth[side_by_side]{};              // NOLINT(modernize-avoid-c-arrays)
};

TOWFORM_VECTOR_CLONES
void add_up(const PushLanes& __restrict lanes, int count, SideBySide& __restrict s)
{
  for (int i = 0; i < count; i += side_by_side)
    for (int k = 0; k < side_by_side; ++k) {
      s.fx[k] += lanes.gx[i + k];
      s.fy[k] += lanes.gy[i + k];
      s.fz[k] += lanes.gz[i + k];
      s.elastic[k] += lanes.elastic[i + k];
      s.damped[k] += lanes.damped[i + k];
      s.rubbed[k] += lanes.rubbed[i + k];
      s.depth[k] = s.depth[k] < lanes.depth[i + k] ? lanes.depth[i + k] : s.depth[k];
    }
}

double total(const double* v) { return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7])); }

} // namespace

ContactSums push(NodeLanes& nodes, const ContactLanes& c, const double* mass, const ContactLaw& law, int count)
{
  PushLanes lanes;
  push_lanes(nodes, c, mass, law, count, lanes);
  const int whole = (count + side_by_side - 1) / side_by_side * side_by_side;
  for (double* v : {lanes.gx, lanes.gy, lanes.gz, lanes.elastic, lanes.damped, lanes.rubbed, lanes.depth})
    std::fill(v + count, v + whole, 0.0);
  SideBySide s;
  add_up(lanes, whole, s);
  return {{total(s.fx), total(s.fy), total(s.fz)},
          total(s.elastic),
          total(s.damped),
          total(s.rubbed),
          *std::max_element(s.depth, s.depth + side_by_side)};
}

} // namespace towform
