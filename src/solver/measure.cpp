#include "solver/measure.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace towform {

namespace {
/// The outline without what lies on the mirror planes.
std::vector<std::array<int, 2>> free_edges(const Blank& blank)
{
  std::vector<std::array<int, 2>> edges = outline_edges(blank.mesh.triangles);
  for (const std::vector<int>* mirror : {&blank.mirror_x, &blank.mirror_y})
    std::erase_if(edges, [&](const std::array<int, 2>& edge) {
      return std::binary_search(mirror->begin(), mirror->end(), edge[0]) &&
             std::binary_search(mirror->begin(), mirror->end(), edge[1]);
    });
  return edges;
}
} // namespace

DrawInGauge::DrawInGauge(const Blank& blank)
{
  const std::vector<Vec3>& points = blank.mesh.points;
  Vec2 low{points[0].x, points[0].y}, high = low;
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const bool half_x = !blank.mirror_x.empty(), half_y = !blank.mirror_y.empty();
  middle_ = {half_x ? 0.0 : 0.5 * (low.x + high.x), half_y ? 0.0 : 0.5 * (low.y + high.y)};
  std::vector<double> sides_x{high.x}, sides_y{high.y};
  if (!half_x) sides_x.push_back(low.x);
  if (!half_y) sides_y.push_back(low.y);

  const auto edges = free_edges(blank);
  const std::vector<Vec3> start = blank.start_positions();
  const auto towards = [&](double x, double y, double wx, double wy) -> Followed {
    const OutlinePoint point = last_crossing(edges, points, middle_, {x, y});
    return {point, distance(point.at(start), wx, wy)};
  };
  for (const double x : sides_x) x_mid_.push_back(towards(x, middle_.y, 1.0, 0.0));
  for (const double y : sides_y) y_mid_.push_back(towards(middle_.x, y, 0.0, 1.0));
  for (const double x : sides_x)
    for (const double y : sides_y) corner_.push_back(towards(x, y, 1.0, 1.0));
}

double DrawInGauge::distance(const Vec3& p, double wx, double wy) const
{
  return std::hypot(wx * (p.x - middle_.x), wy * (p.y - middle_.y));
}

DrawIn DrawInGauge::measure(const System& s) const
{
  const auto mean = [&](const std::vector<Followed>& points, double wx, double wy) {
    double sum = 0.0;
    for (const Followed& f : points) sum += f.at_start - distance(f.point.at(s.sheet.position), wx, wy);
    return sum / static_cast<double>(points.size());
  };
  return {mean(x_mid_, 1.0, 0.0), mean(y_mid_, 0.0, 1.0), mean(corner_, 1.0, 1.0)};
}

void FieldExtremes::tell(Summary& summary) const
{
  summary.shear_angle_max_deg = shear_max * to_degrees;
  summary.shear_angle_p99_deg = shear_p99 * to_degrees;
  summary.fibre_strain_max = strain_max;
  summary.fibre_strain_p99 = strain_p99;
  summary.fibre_strain_over_2_percent = strain_over_2_percent;
  summary.fibre_compression_max = compression_max;
  summary.fibre_compression_p99 = compression_p99;
  summary.fibre_compression_over_half_percent = compression_over_half_percent;
}

FieldExtremes field_extremes(const FieldTail& shear, const FieldTail& strain, const FieldTail& compression)
{
  return {.shear_max = shear.largest,
          .shear_p99 = shear.percentile_99,
          .strain_max = strain.largest,
          .strain_p99 = strain.percentile_99,
          .strain_over_2_percent = strain.fraction_over,
          .compression_max = compression.largest,
          .compression_p99 = compression.percentile_99,
          .compression_over_half_percent = compression.fraction_over,
          .most_sheared = static_cast<int>(shear.place),
          .most_strained = static_cast<int>(strain.place)};
}

FieldExtremes field_extremes(const Membrane& membrane, const System& s)
{
  const std::vector<int>& strip = membrane.strips.of;
  const std::size_t elements = s.sheet.shear_angle.size();
  const auto warp = [&](std::size_t e) { return s.sheet.strip_strain[strip[2 * e]]; };
  const auto weft = [&](std::size_t e) { return s.sheet.strip_strain[strip[2 * e + 1]]; };
  const FieldTail shear = field_tail(elements, 0.0, [&](std::size_t e) { return std::abs(s.sheet.shear_angle[e]); });
  const FieldTail strain =
      field_tail(elements, much_strain, [&](std::size_t e) { return std::max(std::abs(warp(e)), std::abs(weft(e))); });
  const FieldTail compression =
      field_tail(elements, much_compression, [&](std::size_t e) { return std::max({0.0, -warp(e), -weft(e)}); });
  return field_extremes(shear, strain, compression);
}

} // namespace towform
