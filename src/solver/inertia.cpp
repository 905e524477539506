#include "solver/inertia.hpp"
#include "element/held_bending.hpp"
#include "element/mass_lumping.hpp"
#include "element/stable_step.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace towform {

namespace {

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
  model.membrane.damping_time = 0.0;
  if (material.yarn_damping > 0.0)
    model.membrane.damping_time =
        material.yarn_damping *
        StepLimit(model.blank, model.membrane, model.mass, model.shear_modulus).at(flat);
  for (Bending& bending : model.bending)
    bending.damping_time = material.bending_damping * 2.0 / fastest_bending(bending, model.mass);
}

/// Contact with the stiffness that it has at the step, with tools, of a sheet whose masses lie in thirds: that they lie otherwise for
/// longer steps makes it no softer, and steps below half the stable one no stiffer: it would limit them itself.
void set_contacts(const Case& c, Model& model)
{
  if (model.tools.empty()) return;
  const Membrane& membrane = model.membrane;
  const std::vector<double> thirds = lumped(membrane, model.element_mass, std::vector<double>(membrane.node_area.size(), 1.0));
  const StepLimit limit(model.blank, membrane, thirds, model.shear_modulus, model.bending);
  const double beside_tools = std::sqrt(1.0 - 0.25 * c.contact.stick * c.contact.two_tools());
  const double step = std::max(model.safety, 0.5) * beside_tools * limit.at(model.blank.mesh.points);
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
  model.tool_springs = {one.stiffness_per_area, one.damping_per_area, c.contact.stick * one.stiffness_per_area,
                        c.contact.stick * one.damping_per_area};
}

/// Where the sheet's masses lie, and the limit of the step with them [s].
struct Placed {
  std::vector<double> factors; ///< of the nodes, on thirds of their elements' masses
  double limit;
};

/// The limit of the flat sheet between two tools [s].
double pinched_limit(const Model& model)
{
  const std::vector<Vec3>& flat = model.blank.mesh.points;
  const StepLimit limit(model.blank, model.membrane, model.mass, model.shear_modulus, model.bending, model.tool_springs);
  return limit.at(flat, std::vector<double>(flat.size(), 2.0));
}

/// Makes elements heavier until the flat sheet's stable step is the one that is wanted. Heavier elements change what their neighbours'
/// patches are given, and how far the bound is from the limit: a few rounds reach the step.
void scale_masses(const Case& c, const State& flat, const Placed& placed, Model& model)
{
  const double wanted = c.time.step.value_or(0.0) / model.safety;
  constexpr int most_rounds = 20;
  constexpr double aim = 1.001;
  for (int round = 0; round < most_rounds; ++round) {
    const StepBound bound(model.membrane, {model.element_mass, model.mass}, model.shear_modulus, model.bending);
    model.first_look = {round > 0 ? pinched_limit(model) : placed.limit, bound.at(flat).step};
    if (model.first_look.step >= wanted) return;
    const auto factors = bound.mass_factors(flat, aim * wanted / model.first_look.over_bound());
    for (std::size_t e = 0; e < factors.size(); ++e) model.element_mass[e] *= factors[e];
    model.mass = lumped(model.membrane, model.element_mass, placed.factors);
    set_contacts(c, model);
  }
}

/// For how many steps bending forces are held.
int bending_interval(const Bending& bending, const Model& model)
{
  constexpr int most = 8;
  return longest_hold(fastest_bending(bending, model.mass) * model.first_step, bending.damping_time / model.first_step, most);
}

/// Places the masses by the nodes' `factors`, sets damping and contact.
Placed place(const Case& c, std::vector<double> factors, Model& model)
{
  const std::vector<Vec3>& flat = model.blank.mesh.points;
  model.mass = lumped(model.membrane, model.element_mass, factors);
  set_damping(c.material, flat, model);
  set_contacts(c, model);
  return {std::move(factors), pinched_limit(model)};
}

/// Places the masses as the case wants them, or in thirds where the sheet has weight, which hangs where its mass is and bends it
/// accordingly, or where bending limits the step, and it would be shorter otherwise.
Placed place_masses(const Case& c, Model& model)
{
  const std::vector<double> thirds(model.membrane.node_area.size(), 1.0);
  if (c.time.lumping == 0.0 || !model.gravity.empty()) return place(c, thirds, model);
  std::vector<double> factors = lumping_factors(model.blank, model.membrane, c.time.lumping);
  if (model.bending.empty()) return place(c, std::move(factors), model);
  const double limit_of_thirds = place(c, thirds, model).limit;
  Placed as_wanted = place(c, std::move(factors), model); // last, as it mostly stays
  return as_wanted.limit >= limit_of_thirds ? as_wanted : place(c, thirds, model);
}

} // namespace

void set_inertia(const Case& c, Model& model)
{
  const Membrane& membrane = model.membrane;
  State sheet;
  sheet.position = model.blank.mesh.points;
  const double per_area = c.material.constituents.density * c.blank.thickness;
  const std::vector<double> areas = membrane.areas();
  const double own_mass = per_area * std::accumulate(areas.begin(), areas.end(), 0.0);
  for (const double area : areas) model.element_mass.push_back(per_area * area * c.time.mass_scaling);
  model.safety = c.time.safety;
  const Placed placed = place_masses(c, model);
  model.lumped = std::any_of(placed.factors.begin(), placed.factors.end(), [](double factor) { return factor != 1.0; });
  scale_masses(c, sheet, placed, model);
  model.added_mass_fraction = std::max( // not less than none in the last digit
      0.0, std::accumulate(model.element_mass.begin(), model.element_mass.end(), 0.0) / own_mass - 1.0);
  double lightest = HUGE_VAL; // mass per area: where mass scaling has added least
  for (std::size_t e = 0; e < areas.size(); ++e) lightest = std::min(lightest, model.element_mass[e] / areas[e]);
  model.wave_speed = std::sqrt(membrane.yarn.stiffness / lightest);
  model.first_step = model.safety * model.first_look.step;
  if (c.time.subcycling)
    for (Bending& bending : model.bending) bending.interval = bending_interval(bending, model);
}

} // namespace towform
