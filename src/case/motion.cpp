#include "towform/motion.hpp"
#include <algorithm>

namespace towform {

Vec3 unit_vector(Axis axis)
{
  switch (axis) {
  case Axis::x:
    return {1.0, 0.0, 0.0};
  case Axis::y:
    return {0.0, 1.0, 0.0};
  case Axis::z:
    break;
  }
  return {0.0, 0.0, 1.0};
}

namespace {

/// Fraction of the way at the fraction s of the time: the polynomial of least degree whose first and second
/// derivatives vanish at both ends.
double smooth(double s) { return s * s * s * (10.0 + s * (-15.0 + 6.0 * s)); }

double between(const Motion::Point& a, const Motion::Point& b, double t)
{
  const double s = (t - a.time) / (b.time - a.time);
  return (1.0 - s) * a.value + s * b.value; // exact at both ends
}

double interpolated(const std::vector<Motion::Point>& table, double t)
{
  if (table.empty()) return 0.0;
  const auto after = std::upper_bound(table.begin(), table.end(), t,
                                      [](double time, const Motion::Point& p) { return time < p.time; });
  if (after == table.begin()) return table.front().value;
  if (after == table.end()) return table.back().value;
  return between(*(after - 1), *after, t);
}

/// Area under the table from 0 to t: straight lines, so trapezoids are exact.
double integrated(const std::vector<Motion::Point>& table, double t)
{
  if (table.empty()) return 0.0;
  double area = 0.0, time = 0.0, value = interpolated(table, 0.0);
  const auto to = [&](double next, double next_value) {
    area += 0.5 * (value + next_value) * (next - time);
    time = next;
    value = next_value;
  };
  for (const Motion::Point& point : table) {
    if (point.time >= t) break;
    if (point.time > 0.0) to(point.time, point.value);
  }
  to(t, interpolated(table, t));
  return area;
}

} // namespace

double Motion::displacement(double t) const
{
  if (profile == Profile::table)
    return quantity == Quantity::displacement ? interpolated(table, t) : integrated(table, std::max(t, 0.0));
  if (t <= 0.0) return 0.0;
  if (quantity == Quantity::velocity) return amount * t;
  const double s = t >= duration ? 1.0 : t / duration;
  return amount * (profile == Profile::smooth ? smooth(s) : s);
}

} // namespace towform
