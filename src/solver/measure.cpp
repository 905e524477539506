#include "solver/measure.hpp"
#include "parallel/parallel.hpp"
#include "solver/clearance.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {
double velocity_scale(const FabricMaterial& material)
{
  const auto* incremental = std::get_if<IncrementalLaw>(&material.law);
  return incremental ? incremental->velocity_scale : 1.0;
}

void sheet_fields(const Model& model, const State& s, Frame& f)
{
  const ShearCurves& curves = *model.material.curves;
  const double scale = velocity_scale(model.material);
  const Membrane& membrane = model.membrane;
  const std::vector<int>& strip = membrane.strips.of;
  // The sheet keeps its volume: its area grows by lambda1 lambda2 cos(theta) over that of the reference.
  const double reference_cosine = std::sqrt(1.0 - membrane.reference_sine * membrane.reference_sine);
  const std::size_t elements = membrane.triangles.size();
  for (std::vector<double>* field : {&f.shear_angle, &f.shear_rate, &f.curve_position, &f.shear_force, &f.thickness})
    field->resize(elements);
  f.curve_index.resize(elements);
  for (std::vector<Vec3>* field : {&f.fibre_1, &f.fibre_2}) field->resize(elements);
  f.fibre_strain.resize(elements);
  parallel_ranges(static_cast<std::ptrdiff_t>(elements), [&](auto begin, auto end) {
    for (auto e = begin; e < end; ++e) {
      const double rate = s.shear_rate[e];
      f.shear_angle[e] = s.shear_angle[e] * to_degrees;
      f.shear_rate[e] = rate;
      f.curve_index[e] = curves.next_higher(rate * scale);
      f.curve_position[e] = curves.position(rate * scale);
      f.shear_force[e] = s.shear_force[e];
      const YarnVectors y(membrane.triangles[e], membrane.gradients[e], s.position);
      f.fibre_1[e] = y.f1;
      f.fibre_2[e] = y.f2;
      f.fibre_strain[e] = {s.strip_strain[strip[2 * e]], s.strip_strain[strip[2 * e + 1]]};
      f.thickness[e] = membrane.thickness * reference_cosine /
                       (y.lambda1 * y.lambda2 * std::sqrt(1.0 - s.sine[e] * s.sine[e]));
    }
  });
}

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

/// Of an element's corners the value that is largest in size.
double sharpest(const std::vector<YarnPair>& of_node, const Triangle& t, double YarnPair::*family)
{
  double most = 0.0;
  for (const int n : t)
    if (std::abs(of_node[n].*family) > std::abs(most)) most = of_node[n].*family;
  return most;
}
} // namespace

double percentile_99(std::vector<double> values)
{
  const std::size_t rank = (values.size() * 99) / 100;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

Frame make_frame(const Model& model, const System& s, const CurvatureOperator& curvature)
{
  const State& sheet = s.sheet;
  Frame f;
  f.time = sheet.time;
  f.position = sheet.position;
  f.velocity = sheet.velocity;
  f.contact_pressure.assign(sheet.position.size(), 0.0);
  for (std::size_t n = 0; n < sheet.position.size(); ++n) {
    f.velocity[n] += (0.5 * sheet.last_dt / model.mass[n]) * sheet.force[n];
    for (const ContactState& c : s.contacts)
      f.contact_pressure[n] += c.normal_force[n] / model.membrane.node_area[n];
  }
  f.clearance = clearances(model, s);
  sheet_fields(model, sheet, f);
  const std::vector<YarnPair> of_node = curvature.at(sheet.position);
  for (const Triangle& t : model.membrane.triangles)
    f.curvature.push_back({sharpest(of_node, t, &YarnPair::warp), sharpest(of_node, t, &YarnPair::weft)});
  f.temperature.assign(model.membrane.triangles.size(), model.temperature);
  return f;
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
  for (std::size_t e = 0; e < elements; ++e) {
    shear[e] = std::abs(s.sheet.shear_angle[e]);
    const double warp = s.sheet.strip_strain[strip[2 * e]], weft = s.sheet.strip_strain[strip[2 * e + 1]];
    strain[e] = std::max(std::abs(warp), std::abs(weft));
    compression[e] = std::max({0.0, -warp, -weft});
  }
  FieldExtremes x;
  x.most_sheared = static_cast<int>(std::max_element(shear.begin(), shear.end()) - shear.begin());
  x.most_strained = static_cast<int>(std::max_element(strain.begin(), strain.end()) - strain.begin());
  x.shear_max = shear[x.most_sheared];
  x.strain_max = strain[x.most_strained];
  const auto fraction_over = [&](const std::vector<double>& values, double limit) {
    return static_cast<double>(
               std::count_if(values.begin(), values.end(), [limit](double v) { return v > limit; })) /
           static_cast<double>(elements);
  };
  x.strain_over_2_percent = fraction_over(strain, 0.02);
  x.compression_max = *std::max_element(compression.begin(), compression.end());
  x.compression_over_half_percent = fraction_over(compression, 0.005);
  x.compression_p99 = percentile_99(std::move(compression));
  x.shear_p99 = percentile_99(std::move(shear));
  x.strain_p99 = percentile_99(std::move(strain));
  return x;
}

} // namespace towform
