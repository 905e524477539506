#include "solver/run_state.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace towform {

namespace {

using Part = FieldVisitor::Part;

template <class Struct>
void visit_part(FieldVisitor& v, const std::string& name, Struct& s)
{
  const Part part(v, name);
  visit(v, s);
}

template <class Struct>
void visit_list(FieldVisitor& v, const std::string& name, std::vector<Struct>& list)
{
  for (std::size_t i = 0; i < list.size(); ++i) visit_part(v, fmt::format("{}.{}", name, i), list[i]);
}

} // namespace

void visit(FieldVisitor& v, State& s)
{
  auto& [time, step, last_dt, position, velocity, force, strip_strain, sine, shear_angle, shear_force, shear_rate,
         block_force, shear_work, shear_dissipated, yarn_damping, mass_damping] = s;
  v("time", time);
  v("step", step);
  v("last_dt", last_dt);
  v("position", position);
  v("velocity", velocity);
  v("force", force);
  v("strip_strain", strip_strain);
  v("sine", sine);
  v("shear_angle", shear_angle);
  v("shear_force", shear_force);
  v("shear_rate", shear_rate);
  v.rebuilt("block_force");
  v("shear_work", shear_work);
  v("shear_dissipated", shear_dissipated);
  v("yarn_damping", yarn_damping);
  v("mass_damping", mass_damping);
}

void visit(FieldVisitor& v, BendingState& s)
{
  auto& [curvature, held, damping, image] = s;
  v("curvature", curvature);
  v("held", held);
  v("damping", damping);
  v.rebuilt("image");
}

void visit(FieldVisitor& v, PressureState& s)
{
  auto& [force, work] = s;
  v("force", force);
  v("work", work);
}

void visit(FieldVisitor& v, ToolState& s)
{
  auto& [displacement, velocity, reaction, stiffness, work, damped] = s;
  v("displacement", displacement);
  v("velocity", velocity);
  v("reaction", reaction);
  v("stiffness", stiffness);
  v("work", work);
  v("damped", damped);
}

void visit(FieldVisitor& v, ContactState& s)
{
  auto& [stick_x, stick_y, stick_z, normal_force, penetration, deepest_node, energies, planes] = s;
  auto& [elastic, damping, friction] = energies;
  v("stick_x", stick_x);
  v("stick_y", stick_y);
  v("stick_z", stick_z);
  v("normal_force", normal_force);
  v("penetration", penetration);
  v("deepest_node", deepest_node);
  v("elastic", elastic);
  v("damping", damping);
  v("friction", friction);
  v.rebuilt("planes"); // of the facets near each node: remembered to save time, and found again
}

void visit(FieldVisitor& v, BoundaryState& s)
{
  auto& [displacement, moved, force, work] = s;
  v("displacement", displacement);
  v("moved", moved);
  v("force", force);
  v("work", work);
}

void visit(FieldVisitor& v, System& s)
{
  auto& [sheet, bending, pressure, tools, contacts, boundaries, touched, fastest] = s;
  auto& [counted, rings, more] = touched;
  visit_part(v, "sheet", sheet);
  visit_list(v, "bending", bending);
  visit_list(v, "pressure", pressure);
  visit_list(v, "tool", tools);
  visit_list(v, "contact", contacts);
  visit_list(v, "boundary", boundaries);
  v("touched.counted", counted);
  v("touched.rings", rings);
  v("touched.more", more);
  v("fastest", fastest);
}

void visit(FieldVisitor& v, StaticsState& s)
{
  auto& [time, step, last_dt, position, velocity, shear, held_force, group_force, largest_turn, shear_work,
         shear_dissipated, external_work] = s;
  v("time", time);
  v("step", step);
  v("last_dt", last_dt);
  v("position", position);
  v("velocity", velocity);
  v("shear", shear);
  std::vector<double> held(held_force.begin(), held_force.end());
  v("held_force", held);
  std::copy(held.begin(), held.end(), held_force.begin());
  v("group_force", group_force);
  v("largest_turn", largest_turn);
  v("shear_work", shear_work);
  v("shear_dissipated", shear_dissipated);
  v("external_work", external_work);
}

void visit(FieldVisitor& v, Summary& s)
{
  auto& [status, message, elements, nodes, steps, simulated_time_s, wall_time_s, threads, ns_per_element_step,
         step_min_s, step_max_s, energy_error, kinetic_to_internal_max, shear_angle_max_deg,
         shear_angle_p99_deg, fibre_strain_max, fibre_strain_p99, fibre_strain_over_2_percent,
         fibre_compression_max, fibre_compression_p99, fibre_compression_over_half_percent, draw_in_x_mid_mm,
         draw_in_y_mid_mm, draw_in_corner_mm, punch_force_max_N, penetration_max_mm, added_mass_fraction,
         energies_J, phases_s] = s;
  // What a run is told at its start or works out at its end.
  for (const char* name : {"status", "message", "elements", "nodes", "threads", "ns_per_element_step",
                           "added_mass_fraction", "phases_s"})
    v.rebuilt(name);
  v("steps", steps);
  v("simulated_time_s", simulated_time_s);
  v("wall_time_s", wall_time_s);
  v("step_min_s", step_min_s);
  v("step_max_s", step_max_s);
  v("energy_error", energy_error);
  v("kinetic_to_internal_max", kinetic_to_internal_max);
  v("shear_angle_max_deg", shear_angle_max_deg);
  v("shear_angle_p99_deg", shear_angle_p99_deg);
  v("fibre_strain_max", fibre_strain_max);
  v("fibre_strain_p99", fibre_strain_p99);
  v("fibre_strain_over_2_percent", fibre_strain_over_2_percent);
  v("fibre_compression_max", fibre_compression_max);
  v("fibre_compression_p99", fibre_compression_p99);
  v("fibre_compression_over_half_percent", fibre_compression_over_half_percent);
  v("draw_in_x_mid_mm", draw_in_x_mid_mm);
  v("draw_in_y_mid_mm", draw_in_y_mid_mm);
  v("draw_in_corner_mm", draw_in_corner_mm);
  v("punch_force_max_N", punch_force_max_N);
  v("penetration_max_mm", penetration_max_mm);
  const Part part(v, "energy");
  for (auto& [kind, value] : energies_J) v(kind.c_str(), value);
}

void visit(FieldVisitor& v, Record& s)
{
  auto& [summary, frames, rows, deepest, iterations] = s;
  auto& [depth, contact, node, moved, time] = deepest;
  visit_part(v, "summary", summary);
  v("frames", frames);
  v("rows", rows);
  v("deepest.depth", depth);
  v("deepest.contact", contact);
  v("deepest.node", node);
  v("deepest.moved", moved);
  v("deepest.time", time);
  v("iterations", iterations);
}

void visit(FieldVisitor& v, RunState& s)
{
  auto& [system, look, known, stride, event, last_output, record, phases] = s;
  auto& [measured, bound] = look;
  auto& [known_step, known_at] = known;
  auto& [dt, steps_left, arrives] = stride;
  visit(v, system);
  v("look.step", measured);
  v("look.bound", bound);
  v("known.step", known_step);
  v("known.at", known_at);
  v("stride.dt", dt);
  v("stride.steps_left", steps_left);
  v("stride.arrives", arrives);
  v("event", event);
  v("last_output", last_output);
  visit_part(v, "record", record);
  v("phases", phases.all());
}

void visit(FieldVisitor& v, StaticsRunState& s)
{
  auto& [sheet, next_increment, event, record, output, stepping] = s;
  visit_part(v, "sheet", sheet);
  v("next_increment", next_increment);
  v("event", event);
  visit_part(v, "record", record);
  v("output", output);
  v("stepping", stepping);
}

} // namespace towform
