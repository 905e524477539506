#include "solver/model.hpp"
#include "element/strip_lattice.hpp"
#include "parallel/parallel.hpp"
#include "solver/inertia.hpp"
#include "solver/memory.hpp"
#include "solver/placement.hpp"
#include "solver/step.hpp"
#include <algorithm>
#include <cmath>
#include <exception>
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

/// The spring that holds a triangle's yarn strain to its strip's [N/m]: of the order of what shears the
/// sheet, within limits for a sheet that resists almost not or almost like its yarns.
double strip_spring(const Case& c, const Blank& blank, const ShearTable& surface, const YarnLaw& yarn)
{
  constexpr double least_share = 1e-4, most_share = 0.1;
  constexpr double of_any_mesh = 50.0, of_yarns = 300.0; // with more, triangles that cross the yarns lock
  const double wanted = c.material.strip_stiffness.value_or(follows_yarns(blank) ? of_yarns : of_any_mesh);
  const double typical_force = surface.force(0.25 * M_PI, 1.0 / c.time.end);
  return std::clamp(wanted * typical_force, least_share * yarn.stiffness,
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

Model build_model(const Case& c)
{
  std::vector<Made<Tool>> read_tools(c.tools.size());
  Made<Blank> meshed;
  Made<FabricMaterial> tabled;
  const auto tools_to_read = static_cast<int>(c.tools.size());
  parallel_each(tools_to_read + 2, [&](int i) {
    if (i < tools_to_read)
      read_tools[i].make([&] { return read_tool(c.tools[i]); });
    else if (i == tools_to_read)
      meshed.make([&] { return make_blank(c.blank); });
    else
      tabled.make([&] { return make_fabric_material(c.material, c.blank.thickness); });
  });
  std::vector<InputIssue> issues;
  auto blank = input(c, c.blank.mesh.empty() ? "blank" : "blank.mesh", issues, [&] { return meshed.take(); });
  auto material = input(c, "material", issues, [&] { return tabled.take(); });
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
  membrane.own_stiffness = strip_spring(c, *blank, *material->surface, yarn);
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
  give_back_memory();
  set_inertia(c, model);
  return model;
}

System at_rest(const Model& model)
{
  System s;
  s.sheet.position = model.blank.start_positions();
  s.sheet.velocity.assign(s.sheet.position.size(), {});
  s.sheet.force.assign(s.sheet.position.size(), {});
  s.sheet.mass_damping.assign(model.mass_damping > 0.0 ? s.sheet.position.size() : 0, 0.0);
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
  s.touched.counted.assign(s.sheet.position.size(), 2.0); // as the first step does
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
