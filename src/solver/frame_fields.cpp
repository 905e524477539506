#include "solver/frame_fields.hpp"
#include "parallel/parallel.hpp"
#include "solver/clearance.hpp"
#include "solver/measure.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <stdexcept>

namespace towform {

namespace {

double velocity_scale(const FabricMaterial& material)
{
  const auto* incremental = std::get_if<IncrementalLaw>(&material.law);
  return incremental ? incremental->velocity_scale : 1.0;
}

/// What the fields of a frame are made from.
struct FrameState {
  const Model& model;
  const System& system;
  const CurvatureOperator& curvature;

  [[nodiscard]] const State& sheet() const { return system.sheet; }
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

/// value(element, its yarns) for all elements.
template <class T, class Value>
void fill_yarns(const FrameState& s, std::vector<T>& field, const Value& value)
{
  const Membrane& membrane = s.model.membrane;
  field.resize(membrane.triangles.size());
  parallel_each(membrane.blocks.count(), [&](int number) {
    membrane.each_own(number, [&](std::size_t e, const FlatTriangle& flat) {
      field[e] = value(e, YarnVectors(membrane.triangles[e], flat.gradients, s.sheet().position));
    });
  });
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
  fill_yarns(s, f.thickness, [&](std::size_t e, const YarnVectors& y) {
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
       fill_yarns(s, f.fibre_1, [](std::size_t, const YarnVectors& y) { return y.f1; });
     }},
    {"fibre_2",
     [](const FrameState& s, Frame& f) {
       fill_yarns(s, f.fibre_2, [](std::size_t, const YarnVectors& y) { return y.f2; });
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

Frame frame_field(const Model& model, const System& s, const CurvatureOperator& curvature, std::string_view name)
{
  const auto* const field = std::find_if(std::begin(frame_fields), std::end(frame_fields),
                                         [&](const NamedField& f) { return f.name == name; });
  if (field == std::end(frame_fields)) throw std::logic_error(fmt::format("there is no way to make the field {}", name));
  Frame frame;
  field->make({model, s, curvature}, frame);
  return frame;
}

} // namespace towform
