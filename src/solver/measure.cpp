#include "solver/measure.hpp"
#include "parallel/parallel.hpp"
#include "solver/percentile.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

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
  const auto towards = [&](double x, double y) { return last_crossing(edges, points, middle_, {x, y}); };
  for (const double x : sides_x) x_mid_.push_back(towards(x, middle_.y));
  for (const double y : sides_y) y_mid_.push_back(towards(middle_.x, y));
  for (const double x : sides_x)
    for (const double y : sides_y) corner_.push_back(towards(x, y));
}

DrawIn DrawInGauge::measure(const Blank& blank, const System& s) const
{
  const std::vector<Vec3> start = blank.start_positions();
  const auto mean = [&](const std::vector<OutlinePoint>& points, double wx, double wy) {
    const auto distance = [&](const Vec3& p) {
      return std::hypot(wx * (p.x - middle_.x), wy * (p.y - middle_.y));
    };
    double sum = 0.0;
    for (const OutlinePoint& p : points) sum += distance(p.at(start)) - distance(p.at(s.sheet.position));
    return sum / static_cast<double>(points.size());
  };
  return {mean(x_mid_, 1.0, 0.0), mean(y_mid_, 0.0, 1.0), mean(corner_, 1.0, 1.0)};
}

FieldExtremes field_extremes(const Membrane& membrane, const System& s)
{
  const std::vector<int>& strip = membrane.strips.of;
  const std::size_t elements = s.sheet.shear_angle.size();
  const auto warp = [&](std::size_t e) { return s.sheet.strip_strain[strip[2 * e]]; };
  const auto weft = [&](std::size_t e) { return s.sheet.strip_strain[strip[2 * e + 1]]; };
  const auto shear = [&](std::size_t e) { return std::abs(s.sheet.shear_angle[e]); };
  const auto strain = [&](std::size_t e) { return std::max(std::abs(warp(e)), std::abs(weft(e))); };
  const auto compression = [&](std::size_t e) { return std::max({0.0, -warp(e), -weft(e)}); };
  const auto place_of_largest = [elements](const auto& value) {
    std::size_t place = 0;
    for (std::size_t e = 1; e < elements; ++e)
      if (value(e) > value(place)) place = e;
    return static_cast<int>(place);
  };
  const auto fraction_over = [elements](double limit, const auto& value) {
    std::size_t over = 0;
    for (std::size_t e = 0; e < elements; ++e) over += value(e) > limit ? 1 : 0;
    return static_cast<double>(over) / static_cast<double>(elements);
  };
  FieldExtremes x;
  const std::array<std::function<void()>, 3> of_fields{
      [&] {
        x.most_sheared = place_of_largest(shear);
        x.shear_max = shear(static_cast<std::size_t>(x.most_sheared));
        x.shear_p99 = percentile_99(elements, shear);
      },
      [&] {
        x.most_strained = place_of_largest(strain);
        x.strain_max = strain(static_cast<std::size_t>(x.most_strained));
        x.strain_over_2_percent = fraction_over(0.02, strain);
        x.strain_p99 = percentile_99(elements, strain);
      },
      [&] {
        x.compression_max = compression(static_cast<std::size_t>(place_of_largest(compression)));
        x.compression_over_half_percent = fraction_over(0.005, compression);
        x.compression_p99 = percentile_99(elements, compression);
      }};
  parallel_each(static_cast<int>(of_fields.size()), [&](int i) { of_fields[i](); });
  return x;
}

} // namespace towform
