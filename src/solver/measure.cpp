#include "solver/measure.hpp"
#include "parallel/parallel.hpp"
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

double percentile_99(std::vector<double> values)
{
  const std::size_t rank = (values.size() * 99) / 100;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

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
  std::vector<double> shear(elements), strain(elements), compression(elements);
  parallel_ranges(static_cast<std::ptrdiff_t>(elements), [&](auto begin, auto end) {
    for (auto e = begin; e < end; ++e) {
      shear[e] = std::abs(s.sheet.shear_angle[e]);
      const double warp = s.sheet.strip_strain[strip[2 * e]], weft = s.sheet.strip_strain[strip[2 * e + 1]];
      strain[e] = std::max(std::abs(warp), std::abs(weft));
      compression[e] = std::max({0.0, -warp, -weft});
    }
  });
  FieldExtremes x;
  const auto place_of_largest = [](const std::vector<double>& v) {
    return static_cast<int>(std::max_element(v.begin(), v.end()) - v.begin());
  };
  const auto fraction_over = [&](const std::vector<double>& values, double limit) {
    return static_cast<double>(
               std::count_if(values.begin(), values.end(), [limit](double v) { return v > limit; })) /
           static_cast<double>(elements);
  };
  const std::array<std::function<void()>, 3> of_fields{
      [&] {
        x.most_sheared = place_of_largest(shear);
        x.shear_max = shear[x.most_sheared];
        x.shear_p99 = percentile_99(std::move(shear));
      },
      [&] {
        x.most_strained = place_of_largest(strain);
        x.strain_max = strain[x.most_strained];
        x.strain_over_2_percent = fraction_over(strain, 0.02);
        x.strain_p99 = percentile_99(std::move(strain));
      },
      [&] {
        x.compression_max = *std::max_element(compression.begin(), compression.end());
        x.compression_over_half_percent = fraction_over(compression, 0.005);
        x.compression_p99 = percentile_99(std::move(compression));
      }};
  parallel_each(static_cast<int>(of_fields.size()), [&](int i) { of_fields[i](); });
  return x;
}

} // namespace towform
