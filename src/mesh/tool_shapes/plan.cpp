#include "mesh/tool_shapes/plan.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace towform::shapes {

namespace {

int count(double length, double spacing)
{
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

} // namespace

Curve Plan::rectangle(double z) const
{
  return [*this, z](double u) -> Vec3 {
    if (u < 1.0) return {centre * u, half_width, z};
    const double angle = (2.0 - u) * std::numbers::pi / 2.0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double to_side = half_width * c, to_end = (half_length - centre) * s;
    if (to_end > to_side) return {centre + half_width * c / s, half_width, z};
    return {half_length, (half_length - centre) * s / c, z};
  };
}

double Plan::corner() const
{
  return 2.0 - std::atan2(half_width, half_length - centre) * 2.0 / std::numbers::pi;
}

Ring Plan::rim(Quarter& quarter, double z, double spacing) const
{
  std::vector<Vec3> points;
  const int middle = has_middle() ? count(centre, spacing) : 0;
  const int side = count(half_length - centre, spacing), end = count(half_width, spacing);
  points.reserve(middle + side + end + 1);
  for (int i = 0; i < middle; ++i) points.push_back({centre * i / middle, half_width, z});
  for (int i = 0; i < side; ++i)
    points.push_back({centre + (half_length - centre) * i / side, half_width, z});
  for (int i = 0; i <= end; ++i) points.push_back({half_length, half_width * (end - i) / end, z});
  return quarter.ring(std::move(points), middle, middle + side);
}

Ring Plan::even_ring(Quarter& quarter, const Curve& curve, double spacing, bool cornered) const
{
  std::vector<Vec3> points;
  const auto add = [&](double from, double to) {
    constexpr int samples = 64;
    std::vector<double> length{0.0};
    length.reserve(samples + 1);
    Vec3 last = curve(from);
    for (int i = 1; i <= samples; ++i) {
      const Vec3 next = curve(std::lerp(from, to, static_cast<double>(i) / samples));
      length.push_back(length.back() + norm(next - last));
      last = next;
    }
    const int n = count(length.back(), spacing);
    for (int i = 0, k = 0; i < n; ++i) {
      const double wanted = length.back() * i / n;
      while (length[k + 1] < wanted) ++k;
      const double part = (wanted - length[k]) / (length[k + 1] - length[k]);
      points.push_back(curve(std::lerp(from, to, (k + part) / samples)));
    }
  };
  if (has_middle()) add(0.0, 1.0);
  const std::size_t join = points.size();
  std::size_t at_corner = 0;
  if (cornered) {
    add(1.0, corner());
    at_corner = points.size();
    add(corner(), 2.0);
  } else {
    add(1.0, 2.0);
  }
  points.push_back(curve(2.0));
  return quarter.ring(std::move(points), join, at_corner);
}

Ring Plan::spine(Quarter& quarter, double z, int intervals) const
{
  std::vector<Vec3> points;
  const int n = has_middle() ? std::max(1, intervals) : 0;
  points.reserve(n + 1);
  for (int i = 0; i < n; ++i) points.push_back({centre * i / n, 0.0, z});
  points.push_back({centre, 0.0, z});
  return quarter.ring(std::move(points), n);
}

Ring Plan::spine(Quarter& quarter, double z, double spacing) const
{
  return spine(quarter, z, count(centre, spacing));
}

Curve Plan::spine(double z) const
{
  return [*this, z](double u) { return Vec3{centre * std::min(u, 1.0), 0.0, z}; };
}

std::vector<Ring> Plan::between(Quarter& quarter, const Curve& from, const Curve& to, double h_from,
                                double h_to, bool cornered) const
{
  constexpr int samples = 16;
  const double start = has_middle() ? 0.0 : 1.0;
  double distance = 0.0, least = half_length;
  for (int i = 0; i <= samples; ++i) {
    const double u = start + (2.0 - start) * i / samples;
    distance += norm(to(u) - from(u)) / (samples + 1);
    least = std::min(least, norm(to(u) - from(u)));
  }
  // Where the curves come close, chords of coarser rings would cross their neighbours.
  h_from = std::min({h_from, distance / 2.0, 2.0 * least});
  h_to = std::min({h_to, distance / 2.0, 2.0 * least});
  // A geometric series from h_from to h_to that adds up to the distance.
  const double ratio = (distance - h_from) / (distance - h_to);
  const bool uniform = std::abs(ratio - 1.0) < 1e-6;
  const int n =
      std::max(1, static_cast<int>(std::lround(uniform ? distance / h_from
                                                       : 1.0 + std::log(h_to / h_from) / std::log(ratio))));
  std::vector<double> position{0.0}; // summed heights
  position.reserve(n + 1);
  for (int i = 0; i < n; ++i) position.push_back(position.back() + h_from * std::pow(ratio, i));
  std::vector<Ring> rings;
  for (int i = 1; i < n; ++i) {
    const double t = position[i] / position[n];
    const Curve blend = [&from, &to, t](double u) {
      const Vec3 a = from(u), b = to(u);
      return Vec3{(1.0 - t) * a.x + t * b.x, (1.0 - t) * a.y + t * b.y, a.z}; // flat to the bit
    };
    rings.push_back(even_ring(quarter, blend, h_from * std::pow(ratio, i), cornered));
  }
  return rings;
}

} // namespace towform::shapes
