#include "solver/measure.hpp"
#include "parallel/parallel.hpp"
#include "solver/clearance.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace towform {

namespace {
double velocity_scale(const FabricMaterial& material)
{
  const auto* incremental = std::get_if<IncrementalLaw>(&material.law);
  return incremental ? incremental->velocity_scale : 1.0;
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

/// What the fields of a frame are made from.
struct FrameState {
  const Model& model;
  const System& system;
  const CurvatureOperator& curvature;

  [[nodiscard]] const State& sheet() const { return system.sheet; }
  [[nodiscard]] YarnVectors yarns(std::size_t element) const
  {
    const Membrane& membrane = model.membrane;
    return {membrane.triangles[element], membrane.gradients[element], sheet().position};
  }
};

/// value(i) for all nodes or elements.
template <class T, class Value>
void fill(std::vector<T>& field, std::size_t size, const Value& value)
{
  field.resize(size);
  parallel_ranges(static_cast<std::ptrdiff_t>(size), [&](auto begin, auto end) {
    for (auto i = begin; i < end; ++i) field[i] = value(static_cast<std::size_t>(i));
  });
}
template <class T, class Value>
void fill_elements(const FrameState& s, std::vector<T>& field, const Value& value)
{
  fill(field, s.model.membrane.triangles.size(), value);
}

void velocity(const FrameState& s, Frame& f)
{
  const State& sheet = s.sheet();
  fill(f.velocity, sheet.position.size(), [&](std::size_t n) {
    return sheet.velocity[n] + (0.5 * sheet.last_dt / s.model.mass[n]) * sheet.force[n];
  });
}

void contact_pressure(const FrameState& s, Frame& f)
{
  fill(f.contact_pressure, s.sheet().position.size(), [&](std::size_t n) {
    double pressure = 0.0;
    for (const ContactState& c : s.system.contacts) pressure += c.normal_force[n] / s.model.membrane.node_area[n];
    return pressure;
  });
}

void curve_index(const FrameState& s, Frame& f)
{
  const double scale = velocity_scale(s.model.material);
  fill_elements(s, f.curve_index, [&](std::size_t e) {
    return s.model.material.curves->next_higher(s.sheet().shear_rate[e] * scale);
  });
}

void curve_position(const FrameState& s, Frame& f)
{
  const double scale = velocity_scale(s.model.material);
  fill_elements(s, f.curve_position, [&](std::size_t e) {
    return s.model.material.curves->position(s.sheet().shear_rate[e] * scale);
  });
}

void fibre_strain(const FrameState& s, Frame& f)
{
  const std::vector<int>& strip = s.model.membrane.strips.of;
  const std::vector<double>& strain = s.sheet().strip_strain;
  fill_elements(s, f.fibre_strain, [&](std::size_t e) {
    return std::array<double, 2>{strain[strip[2 * e]], strain[strip[2 * e + 1]]};
  });
}

/// Of an element's corners the value that is largest in size.
double sharpest(const std::vector<YarnPair>& of_node, const Triangle& t, double YarnPair::*family)
{
  double most = 0.0;
  for (const int n : t)
    if (std::abs(of_node[n].*family) > std::abs(most)) most = of_node[n].*family;
  return most;
}

void curvature(const FrameState& s, Frame& f)
{
  const std::vector<YarnPair> of_node = s.curvature.at(s.sheet().position);
  fill_elements(s, f.curvature, [&](std::size_t e) {
    const Triangle& t = s.model.membrane.triangles[e];
    return std::array<double, 2>{sharpest(of_node, t, &YarnPair::warp), sharpest(of_node, t, &YarnPair::weft)};
  });
}

/// The sheet keeps its volume: its area grows by lambda1 lambda2 cos(theta) over that of the reference.
void thickness(const FrameState& s, Frame& f)
{
  const Membrane& membrane = s.model.membrane;
  const double reference_cosine = std::sqrt(1.0 - membrane.reference_sine * membrane.reference_sine);
  fill_elements(s, f.thickness, [&](std::size_t e) {
    const YarnVectors y = s.yarns(e);
    const double sine = s.sheet().sine[e];
    return membrane.thickness * reference_cosine / (y.lambda1 * y.lambda2 * std::sqrt(1.0 - sine * sine));
  });
}

struct NamedField {
  const char* name;
  void (*make)(const FrameState&, Frame&);
};

constexpr NamedField frame_fields[] = {
    {"position", [](const FrameState& s, Frame& f) { f.position = s.sheet().position; }},
    {"velocity", velocity},
    {"contact_pressure", contact_pressure},
    {"clearance", [](const FrameState& s, Frame& f) { f.clearance = clearances(s.model, s.system); }},
    {"shear_angle",
     [](const FrameState& s, Frame& f) {
       fill_elements(s, f.shear_angle, [&](std::size_t e) { return s.sheet().shear_angle[e] * to_degrees; });
     }},
    {"shear_rate", [](const FrameState& s, Frame& f) { f.shear_rate = s.sheet().shear_rate; }},
    {"curve_index", curve_index},
    {"curve_position", curve_position},
    {"shear_force", [](const FrameState& s, Frame& f) { f.shear_force = s.sheet().shear_force; }},
    {"fibre_1",
     [](const FrameState& s, Frame& f) {
       fill_elements(s, f.fibre_1, [&](std::size_t e) { return s.yarns(e).f1; });
     }},
    {"fibre_2",
     [](const FrameState& s, Frame& f) {
       fill_elements(s, f.fibre_2, [&](std::size_t e) { return s.yarns(e).f2; });
     }},
    {"fibre_strain", fibre_strain},
    {"curvature", curvature},
    {"thickness", thickness},
    {"temperature",
     [](const FrameState& s, Frame& f) {
       f.temperature.assign(s.model.membrane.triangles.size(), s.model.temperature);
     }},
};

} // namespace

double percentile_99(std::vector<double> values)
{
  const std::size_t rank = (values.size() * 99) / 100;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

Frame frame_field(const Model& model, const System& s, const CurvatureOperator& curvature, std::string_view name)
{
  const auto* const field = std::find_if(std::begin(frame_fields), std::end(frame_fields),
                                         [&](const NamedField& f) { return f.name == name; });
  if (field == std::end(frame_fields)) throw std::logic_error(fmt::format("there is no way to make the field {}", name));
  Frame frame;
  field->make({model, s, curvature}, frame);
  return frame;
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
