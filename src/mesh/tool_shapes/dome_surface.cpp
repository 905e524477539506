#include "mesh/tool_shapes/dome_surface.hpp"
#include <algorithm>
#include <cmath>

namespace towform::shapes {

using std::numbers::pi;

DomeSurface::Profile DomeSurface::profile(double s) const
{
  const double t = std::min(s, arc_end()), wall = s - t;
  const double sine = std::sin(t), cosine = std::cos(t);
  return {sine + cosine * wall, cosine, radius * (1.0 - cosine + sine * wall), radius * sine};
}

double DomeSurface::s_at_rise(double rise) const
{
  const Profile end = profile(arc_end());
  if (rise < end.rise) return std::acos(1.0 - rise / radius);
  return arc_end() + (rise - end.rise) / end.rise_s;
}

DomeSurface::Width DomeSurface::width(double x) const
{
  const double k = pi / centre, half = (waist - radius) / 2.0;
  return {(radius + waist) / 2.0 + half * std::cos(k * x), -half * k * std::sin(k * x),
          -half * k * k * std::cos(k * x)};
}

Vec3 DomeSurface::point(double u, double s) const
{
  const Profile p = profile(s);
  if (u < 1.0) return {centre * u, width(centre * u).w * p.a, p.rise};
  const double angle = (2.0 - u) * pi / 2.0;
  return {centre + radius * p.a * std::cos(angle), radius * p.a * std::sin(angle), p.rise};
}

Vec3 DomeSurface::normal(double u, double s) const
{
  const Profile p = profile(s);
  if (u < 1.0) {
    const Width w = width(centre * u);
    // The cross product of the surface's two derivatives (1, w' a, 0) and (0, w a', rise').
    return normalized({-w.w_x * p.a * p.rise_s, p.rise_s, -w.w * p.a_s});
  }
  const double angle = (2.0 - u) * pi / 2.0;
  return normalized({p.rise_s * std::cos(angle), p.rise_s * std::sin(angle), -radius * p.a_s});
}

double DomeSurface::concave_curvature(double s_end) const
{
  if (centre <= 0.0) return 0.0;
  constexpr int samples = 64;
  double largest = 0.0;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) {
      const double x = centre * i / samples, s = s_end * j / samples;
      const Profile p = profile(s);
      const Width w = width(x);
      const Vec3 n = normalized({-w.w_x * p.a * p.rise_s, p.rise_s, -w.w * p.a_s});
      const Vec3 along{1.0, w.w_x * p.a, 0.0}, up{0.0, w.w * p.a_s, p.rise_s};
      const double a_ss = s < arc_end() ? -p.a : 0.0, rise_ss = s < arc_end() ? radius * p.a_s : 0.0;
      // First and second fundamental forms; seen against n a convex direction has negative curvature.
      const double E = dot(along, along), F = dot(along, up), G = dot(up, up);
      const double L = w.w_xx * p.a * n.y, M = w.w_x * p.a_s * n.y, N = w.w * a_ss * n.y + rise_ss * n.z;
      const double area = E * G - F * F;
      const double mean = (E * N - 2.0 * F * M + G * L) / (2.0 * area), gauss = (L * N - M * M) / area;
      largest = std::max(largest, mean + std::sqrt(std::max(0.0, mean * mean - gauss)));
    }
  return largest;
}

double DomeSurface::outline_curvature() const
{
  return centre > 0.0 ? std::abs(radius - waist) / 2.0 * (pi / centre) * (pi / centre) : 0.0;
}

} // namespace towform::shapes
