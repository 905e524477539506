#include "solver/model.hpp"
#include "element/held_bending.hpp"
#include "element/mass_lumping.hpp"
#include "element/stable_step.hpp"
#include "parallel/parallel.hpp"
#include "solver/placement.hpp"
#include "solver/step.hpp"
#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <optional>

namespace towform {

namespace {

Tool read_tool(const ToolParameters& p)
{
  SurfaceMesh mesh = read_stl(p.mesh, p.mesh_unit);
  for (Vec3& x : mesh.points) x += p.position;
  const Axis axis = p.motion ? p.motion->axis : p.axis;
  return {p.name, ToolSurface(std::move(mesh)), p.friction, p.motion, p.force, unit_vector(axis), p.mass, p.damping};
}

/// What is made beside others, or why it could not be: an exception must not leave its thread.
template <class T>
struct Made {
  std::optional<T> it;
  std::exception_ptr failed;

  template <class Make>
  void make(const Make& its_make)
  {
    try {
      it = its_make();
    } catch (...) {
      failed = std::current_exception();
    }
  }
  T take()
  {
    if (failed) std::rethrow_exception(failed);
    return std::move(*it);
  }
};

/// The tools that could be read; the others become issues.
std::vector<Tool> tools_from(std::vector<Made<Tool>>& read, const Case& c, std::vector<InputIssue>& issues)
{
  std::vector<Tool> tools;
  for (std::size_t i = 0; i < read.size(); ++i) {
    try {
      tools.push_back(read[i].take());
    } catch (const FileError& e) {
      issues.push_back({c.where("tool[" + std::to_string(i) + "].mesh"), e.what(), ExitCode::files});
    }
  }
  return tools;
}

/// Bound of dN/dtheta of the law, the shear part of the stable step [N/m].
double shear_modulus_bound(const FabricMaterial& material)
{
  if (const auto* viscous = std::get_if<ViscousLaw>(&material.law)) return viscous->modulus;
  double bound = 0.0;
  for (const ShearCurve& curve : material.curves->curves)
    for (int i = 0; i <= 75; ++i) bound = std::max(bound, std::abs(curve.slope(i * M_PI / 180.0)));
  if (const auto* elastic = std::get_if<ElasticLaw>(&material.law))
    bound = std::max(bound, elastic->curves->curves.front().force(ElasticLaw::joint) / ElasticLaw::joint);
  return bound;
}

/// `factors` on the thirds of their elements' masses, of every node.
std::vector<double> lumped(const Membrane& membrane, std::span<const double> element_mass, std::span<const double> factors)
{
  std::vector<double> mass(factors.size(), 0.0);
  for (std::size_t e = 0; e < element_mass.size(); ++e)
    for (const int n : membrane.triangles[e]) mass[n] += element_mass[e] / 3.0;
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] *= factors[n];
  return mass;
}

/// [rad/s]
double fastest_bending(const Bending& bending, std::span<const double> mass)
{
  const std::vector<double> squares = bending.frequency_bound(mass);
  return std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

/// Damping times from what is critical for the fastest waves, of the sheet before selective mass scaling.
void set_damping(const MaterialParameters& material, std::span<const Vec3> flat, Model& model)
{
  constexpr double near = 1e-6; // any: there is no damping yet
  if (material.yarn_damping > 0.0)
    model.membrane.damping_time =
        material.yarn_damping *
        StepLimit(model.blank, model.membrane, model.mass, model.shear_modulus).at(flat, near);
  for (Bending& bending : model.bending)
    bending.damping_time = material.bending_damping * 2.0 / fastest_bending(bending, model.mass);
}

/// A wave's time over an element: unlike the bound, the same for a quarter as for the whole.
double wave_step(const Model& model)
{
  const double lightest = *std::min_element(model.element_mass.begin(), model.element_mass.end());
  return std::sqrt(2.0 * lightest / model.membrane.yarn.stiffness);
}

/// Contact with the stiffness that it has at the step of a sheet whose masses lie in thirds: that they lie otherwise for longer
/// steps makes it no softer.
void set_contacts(const Case& c, Model& model)
{
  if (model.tools.empty()) return;
  const Membrane& membrane = model.membrane;
  const std::vector<double> thirds = lumped(membrane, model.element_mass, std::vector<double>(membrane.node_area.size(), 1.0));
  const StepLimit limit(model.blank, membrane, thirds, model.shear_modulus, model.bending);
  const double step = model.safety * limit.at(model.blank.mesh.points, wave_step(model));
  const double mass_per_area = c.material.constituents.density * c.blank.thickness * c.time.mass_scaling;
  model.contacts.clear();
  for (std::size_t i = 0; i < model.tools.size(); ++i) {
    model.contacts.emplace_back(model.tools[i], static_cast<int>(i), 0.5 * c.blank.thickness, c.contact.penalty,
                                c.contact.damping, mass_per_area, step);
    Contact& contact = model.contacts.back();
    contact.stick_ratio = c.contact.stick;
    contact.soft = c.contact.soft;
    contact.soft_depth = c.contact.soft_depth * c.blank.thickness;
  }
  const Contact& one = model.contacts.front();
  model.tool_springs = {2.0 * one.stiffness_per_area, 2.0 * one.damping_per_area,
                        2.0 * c.contact.stick * one.stiffness_per_area, 2.0 * c.contact.stick * one.damping_per_area};
}

/// Sets contact, looks at the flat sheet's stable step and makes elements heavier until it is the one that is wanted. Heavier elements change what their
/// neighbours' patches are given, and how far the bound is from the limit: a few rounds reach the step.
void scale_masses(const Case& c, const State& flat, std::span<const double> lumping, Model& model)
{
  const double wanted = c.time.step.value_or(0.0) / model.safety;
  constexpr int most_rounds = 20;
  constexpr double aim = 1.001;
  for (int round = 0; round < most_rounds; ++round) {
    const StepBound bound(model.membrane, {model.element_mass, model.mass}, model.shear_modulus, model.bending);
    set_contacts(c, model);
    model.first_look = look_at_step(model, bound, flat);
    if (model.first_look.step >= wanted) return;
    const auto factors = bound.mass_factors(flat, aim * wanted / model.first_look.over_bound());
    for (std::size_t e = 0; e < factors.size(); ++e) model.element_mass[e] *= factors[e];
    model.mass = lumped(model.membrane, model.element_mass, lumping);
  }
}

/// For how many steps bending forces are held.
int bending_interval(const Bending& bending, const Model& model)
{
  constexpr int most = 8;
  return longest_hold(fastest_bending(bending, model.mass) * model.first_step, bending.damping_time / model.first_step, most);
}

/// Places the masses, sets damping and contact; returns the limit of the step [s].
double place_masses(const Case& c, std::span<const double> lumping, Model& model)
{
  const std::vector<Vec3>& flat = model.blank.mesh.points;
  model.mass = lumped(model.membrane, model.element_mass, lumping);
  set_damping(c.material, flat, model);
  set_contacts(c, model);
  return StepLimit(model.blank, model.membrane, model.mass, model.shear_modulus, model.bending, model.tool_springs)
      .at(flat, wave_step(model));
}

/// The nodes' factors on thirds of their elements' masses: as the case wants them, or all 1 where the sheet has weight, which hangs
/// where its mass is and bends it accordingly, or where bending limits the step, and it would be shorter with them.
std::vector<double> find_lumping(const Case& c, Model& model)
{
  const std::vector<double> thirds(model.membrane.node_area.size(), 1.0);
  if (c.time.lumping == 0.0 || !model.gravity.empty()) return thirds;
  std::vector<double> factors = lumping_factors(model.blank, model.membrane, c.time.lumping);
  if (model.bending.empty()) return factors;
  return place_masses(c, factors, model) >= place_masses(c, thirds, model) ? factors : thirds;
}

/// Masses, steps and contact stiffnesses: what depends on one another.
void set_inertia(const Case& c, Model& model)
{
  const Membrane& membrane = model.membrane;
  State sheet;
  sheet.position = model.blank.mesh.points;
  const double per_area = c.material.constituents.density * c.blank.thickness;
  const double own_mass = per_area * std::accumulate(membrane.area.begin(), membrane.area.end(), 0.0);
  for (const double area : membrane.area) model.element_mass.push_back(per_area * area * c.time.mass_scaling);
  model.safety = c.time.safety;
  const std::vector<double> lumping = find_lumping(c, model);
  model.mass = lumped(membrane, model.element_mass, lumping);
  set_damping(c.material, sheet.position, model);
  scale_masses(c, sheet, lumping, model);
  model.added_mass_fraction = std::max( // not less than none in the last digit
      0.0, std::accumulate(model.element_mass.begin(), model.element_mass.end(), 0.0) / own_mass - 1.0);
  double lightest = HUGE_VAL; // mass per area: where mass scaling has added least
  for (std::size_t e = 0; e < membrane.area.size(); ++e)
    lightest = std::min(lightest, model.element_mass[e] / membrane.area[e]);
  model.wave_speed = std::sqrt(membrane.yarn.stiffness / lightest);
  model.first_step = model.safety * model.first_look.step;
  if (c.time.subcycling)
    for (Bending& bending : model.bending) bending.interval = bending_interval(bending, model);
}

/// The spring that holds a triangle's yarn strain to its strip's [N/m]: of the order of what shears the
/// sheet, within limits for a sheet that resists almost not or almost like its yarns.
double strip_spring(const Case& c, const ShearTable& surface, const YarnLaw& yarn)
{
  constexpr double least_share = 1e-4, most_share = 0.1;
  const double typical_force = surface.force(0.25 * M_PI, 1.0 / c.time.end);
  return std::clamp(c.material.strip_stiffness * typical_force, least_share * yarn.stiffness,
                    most_share * yarn.stiffness);
}

template <class Make>
auto input(const Case& c, const std::string& key, std::vector<InputIssue>& issues, Make make)
    -> std::optional<decltype(make())>
{
  try {
    return make();
  } catch (const std::logic_error& e) { // invalid_argument and domain_error: the user's values
    issues.push_back({c.where(key), e.what()});
  } catch (const FileError& e) {
    issues.push_back({c.where(key), e.what(), ExitCode::files});
  } catch (const InputError& e) { // a file named by the key, with places of its own
    issues.insert(issues.end(), e.issues().begin(), e.issues().end());
  }
  return std::nullopt;
}

/// Edges that grips hold: the sheet leaves them without a slope.
std::vector<SymmetryLine> clamped_edges(const Case& c, const std::vector<Boundary>& boundaries)
{
  using Edge = BoundaryParameters::Edge;
  std::vector<SymmetryLine> lines;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const BoundaryParameters& p = c.boundaries[i];
    if (p.kind != BoundaryParameters::Kind::grip) continue;
    const bool upright = p.edge == Edge::left || p.edge == Edge::right;
    lines.push_back({upright ? SymmetryLine::Across::x : SymmetryLine::Across::y, boundaries[i].nodes});
  }
  return lines;
}

Bending make_bending(const Case& c, const Model& model)
{
  const MaterialParameters& m = c.material;
  const auto law = [&](double Vec2::*family) {
    return m.bending_stiffness ? MomentLaw((*m.bending_stiffness).*family) : MomentLaw(m.bending_table);
  };
  return {model.blank, model.clamped, model.membrane.node_area, law(&Vec2::x), law(&Vec2::y)};
}

Gravity make_gravity(const Case& c, const Membrane& membrane)
{
  Gravity gravity;
  const double per_area = c.material.constituents.density * c.blank.thickness;
  for (const double area : membrane.node_area) gravity.weight.push_back((per_area * area) * c.load.gravity);
  return gravity;
}

double mirror_factor(Symmetry symmetry)
{
  return symmetry == Symmetry::none ? 1.0 : symmetry == Symmetry::quarter ? 4.0 : 2.0;
}

} // namespace

StepLook look_at_step(const Model& model, const StepBound& bound, const State& s)
{
  const StepLimit limit(model.blank, model.membrane, model.mass, model.shear_modulus, model.bending, model.tool_springs);
  return {limit.at(s.position, wave_step(model)), bound.at(s).step};
}

Model build_model(const Case& c)
{
  std::vector<Made<Tool>> read_tools(c.tools.size());
  Made<Blank> meshed;
  parallel_each(static_cast<int>(c.tools.size()) + 1, [&](int i) {
    const auto number = static_cast<std::size_t>(i);
    if (number < c.tools.size())
      read_tools[number].make([&] { return read_tool(c.tools[number]); });
    else
      meshed.make([&] { return make_blank(c.blank); });
  });
  std::vector<InputIssue> issues;
  auto blank = input(c, c.blank.mesh.empty() ? "blank" : "blank.mesh", issues, [&] { return meshed.take(); });
  auto material =
      input(c, "material", issues, [&] { return make_fabric_material(c.material, c.blank.thickness); });
  std::vector<Tool> tools = tools_from(read_tools, c, issues);
  if (blank && tools.size() == c.tools.size()) check_placement(c, *blank, tools, issues);
  std::vector<Boundary> boundaries;
  for (std::size_t i = 0; blank && i < c.boundaries.size(); ++i) {
    const std::string key = "boundary[" + std::to_string(i) + "]";
    if (auto made = input(c, key, issues,
                          [&] { return make_boundary(c.boundaries[i], c.blank, *blank, c.time.end); }))
      boundaries.push_back(std::move(*made));
  }
  if (!issues.empty()) throw InputError(std::move(issues));

  const YarnLaw yarn{c.material.fibre_modulus * c.blank.thickness, c.material.compression_factor};
  Membrane membrane(*blank, yarn, material->law, c.material.yarn_strain);
  membrane.own_stiffness = strip_spring(c, *material->surface, yarn);
  Model model(std::move(*blank), std::move(*material), std::move(membrane));
  model.clamped = clamped_edges(c, boundaries);
  if (c.material.has_bending())
    if (auto bending = input(c, "blank", issues, [&] { return make_bending(c, model); }))
      model.bending.push_back(std::move(*bending));
  if (!issues.empty()) throw InputError(std::move(issues));
  if (c.load.gravity != Vec3{}) model.gravity.push_back(make_gravity(c, model.membrane));
  if (!c.load.pressure.empty()) {
    const SurfaceMesh& mesh = model.blank.mesh;
    model.pressure.push_back({c.load.pressure, ElementsOfNode(mesh.triangles, mesh.points.size())});
  }
  model.tools = std::move(tools);
  model.boundaries = std::move(boundaries);
  model.temperature = c.material.temperature;
  model.mass_damping = c.time.mass_damping;
  model.shear_modulus = shear_modulus_bound(model.material);
  model.mirror_factor = mirror_factor(c.blank.symmetry);
  set_inertia(c, model);
  return model;
}

System at_rest(const Model& model)
{
  System s;
  s.sheet.position = model.blank.start_positions();
  s.sheet.velocity.assign(s.sheet.position.size(), {});
  s.sheet.force.assign(s.sheet.position.size(), {});
  s.sheet.mass_damping.assign(s.sheet.position.size(), 0.0);
  start(model.membrane, s.sheet);
  s.bending.resize(model.bending.size());
  for (std::size_t i = 0; i < model.bending.size(); ++i)
    start(model.bending[i], s.sheet.position, s.bending[i]);
  s.pressure.resize(model.pressure.size());
  for (PressureState& pressure : s.pressure) pressure.force.assign(s.sheet.position.size(), {});
  s.tools.resize(model.tools.size());
  s.contacts.resize(model.contacts.size());
  for (std::size_t i = 0; i < model.contacts.size(); ++i)
    start(model.contacts[i], s.sheet.position.size(), s.contacts[i]);
  s.boundaries.resize(model.boundaries.size());
  return s;
}

System start(const Model& model)
{
  System s = at_rest(model);
  Phases untimed;
  evaluate_forces(model, s, model.first_step, untimed);
  return s;
}

} // namespace towform
