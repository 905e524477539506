#include "contact/contact_batch.hpp"
#include "parallel/vector_clones.hpp"
#include <cmath>

namespace towform {

TOWFORM_VECTOR_CLONES
void push(ContactBatch& b, double stick_ratio, double friction, double dt)
{
  const int count = b.count;
  for (int i = 0; i < count; ++i) {
    const double nx = b.nx[i], ny = b.ny[i], nz = b.nz[i], vx = b.vx[i], vy = b.vy[i], vz = b.vz[i];
    const double opening = vx * nx + vy * ny + vz * nz;
    const double elastic = -b.stiffness[i] * b.gap[i], wanted = elastic - b.damping[i] * opening;
    const double pressed = wanted > 0.0 ? wanted : 0.0;

    const double tx = dt * (vx - opening * nx), ty = dt * (vy - opening * ny), tz = dt * (vz - opening * nz);
    const double lift = b.sx[i] * nx + b.sy[i] * ny + b.sz[i] * nz;
    const double rx = b.sx[i] - lift * nx + tx, ry = b.sy[i] - lift * ny + ty, rz = b.sz[i] - lift * nz + tz;
    const double spring = stick_ratio * b.stiffness[i], limit = friction * pressed;
    const double stretch = std::sqrt(rx * rx + ry * ry + rz * rz);
    const bool slips = spring * stretch > limit;
    const double back = limit / (spring * stretch), kept = slips ? back : 1.0;
    const double sx = kept * rx, sy = kept * ry, sz = kept * rz;
    const double dashpot = slips ? 0.0 : b.damping[i] / dt;
    const double hx = -spring * sx - dashpot * tx, hy = -spring * sy - dashpot * ty,
                 hz = -spring * sz - dashpot * tz;
    const double size = std::sqrt(hx * hx + hy * hy + hz * hz);
    const double cut = limit / size, share = slips ? 1.0 : size > limit ? cut : 1.0;
    const double gx = share * hx, gy = share * hy, gz = share * hz;
    const double by_slip = limit * (stretch - limit / spring);
    const double by_dashpot = -((gx + spring * sx) * tx + (gy + spring * sy) * ty + (gz + spring * sz) * tz);

    b.sx[i] = sx;
    b.sy[i] = sy;
    b.sz[i] = sz;
    b.fx[i] = pressed * nx + gx;
    b.fy[i] = pressed * ny + gy;
    b.fz[i] = pressed * nz + gz;
    b.normal_force[i] = pressed;
    b.elastic[i] = 0.5 * b.stiffness[i] * b.gap[i] * b.gap[i] + 0.5 * spring * (sx * sx + sy * sy + sz * sz);
    b.damped[i] = (elastic - pressed) * opening * dt;
    b.rubbed[i] = slips ? by_slip : by_dashpot;
  }
}

} // namespace towform
