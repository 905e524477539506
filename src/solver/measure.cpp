#include "solver/measure.hpp"
#include "solver/clearance.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace towform {

namespace {
constexpr double to_degrees = 180.0 / M_PI;

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
  for (std::size_t e = 0; e < membrane.triangles.size(); ++e) {
    const ShearPoint& p = s.shear[e];
    f.shear_angle.push_back(p.angle * to_degrees);
    f.shear_rate.push_back(p.rate);
    f.curve_index.push_back(curves.next_higher(p.rate * scale));
    f.curve_position.push_back(curves.position(p.rate * scale));
    f.shear_force.push_back(p.force);
    const YarnVectors y(membrane.triangles[e], membrane.gradients[e], s.position);
    f.fibre_1.push_back(y.f1);
    f.fibre_2.push_back(y.f2);
    f.fibre_strain.push_back({y.lambda1 - 1.0, y.lambda2 - 1.0});
    f.thickness.push_back(membrane.thickness /
                          (y.lambda1 * y.lambda2 * std::sqrt(1.0 - s.sine[e] * s.sine[e])));
  }
}

/// The node nearest to a point of the flat blank; -1 when the point is not in the modelled part.
int node_at(const Blank& blank, double x, double y)
{
  int best = -1;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < blank.mesh.points.size(); ++n) {
    const double d = std::hypot(blank.mesh.points[n].x - x, blank.mesh.points[n].y - y);
    if (d < nearest) {
      nearest = d;
      best = static_cast<int>(n);
    }
  }
  return best;
}

/// Of an element's corners the value that is largest in size.
double sharpest(const std::vector<YarnPair>& of_node, const Triangle& t, double YarnPair::*family)
{
  double most = 0.0;
  for (const int n : t)
    if (std::abs(of_node[n].*family) > std::abs(most)) most = of_node[n].*family;
  return most;
}

double percentile_99(std::vector<double> values)
{
  const std::size_t rank = (values.size() * 99) / 100;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}
} // namespace

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
  double x_min = 0.0, x_max = 0.0, y_min = 0.0, y_max = 0.0;
  for (const Vec3& p : blank.mesh.points) {
    x_min = std::min(x_min, p.x);
    x_max = std::max(x_max, p.x);
    y_min = std::min(y_min, p.y);
    y_max = std::max(y_max, p.y);
  }
  // A side at 0 is a mirror, not an edge.
  for (const double x : {x_min, x_max})
    if (x != 0.0) x_mid_.push_back(node_at(blank, x, 0.0));
  for (const double y : {y_min, y_max})
    if (y != 0.0) y_mid_.push_back(node_at(blank, 0.0, y));
  for (const double x : {x_min, x_max})
    for (const double y : {y_min, y_max})
      if (x != 0.0 && y != 0.0) corner_.push_back(node_at(blank, x, y));
}

DrawIn DrawInGauge::measure(const Blank& blank, const System& s) const
{
  const auto mean = [&](const std::vector<int>& nodes, double wx, double wy) {
    double sum = 0.0;
    for (const int n : nodes) {
      const Vec3 &from = blank.mesh.points[n], &to = s.sheet.position[n];
      sum += std::hypot(wx * from.x, wy * from.y) - std::hypot(wx * to.x, wy * to.y);
    }
    return sum / static_cast<double>(nodes.size());
  };
  return {mean(x_mid_, 1.0, 0.0), mean(y_mid_, 0.0, 1.0), mean(corner_, 1.0, 1.0)};
}

FieldExtremes field_extremes(const System& s)
{
  const std::size_t elements = s.sheet.shear.size();
  std::vector<double> shear(elements), strain(elements), compression(elements);
  for (std::size_t e = 0; e < elements; ++e) {
    shear[e] = std::abs(s.sheet.shear[e].angle);
    strain[e] = std::max(std::abs(s.sheet.yarn_strain[e].warp), std::abs(s.sheet.yarn_strain[e].weft));
    compression[e] = std::max({0.0, -s.sheet.yarn_strain[e].warp, -s.sheet.yarn_strain[e].weft});
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
