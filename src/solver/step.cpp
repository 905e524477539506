#include "solver/step.hpp"
#include "parallel/parallel.hpp"
#include "solver/kick_and_drift.hpp"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

namespace towform {

namespace {

/// Raises `most`; a maximum is the same in any order.
void raise(std::atomic<double>& most, double value)
{
  double known = most.load();
  while (known < value && !most.compare_exchange_weak(known, value)) {
  }
}

/// With drag, whose work is counted; as kick_and_drift otherwise.
double move_through_drag(const Model& model, State& s, std::ptrdiff_t begin, std::ptrdiff_t end, double kick, double dt)
{
  const double drag = 0.5 * model.mass_damping * kick;
  double fastest = 0.0;
  for (auto n = begin; n < end; ++n) {
    const Vec3 before = s.velocity[n];
    const Vec3 after = (1.0 / (1.0 + drag)) * ((1.0 - drag) * before + (kick / model.mass[n]) * s.force[n]);
    s.mass_damping[n] += model.mass_damping * model.mass[n] * 0.25 * norm_squared(before + after) * kick;
    s.velocity[n] = after;
    s.position[n] += dt * after;
    const double squared = norm_squared(after);
    fastest = std::max(fastest, std::isfinite(squared) ? squared : HUGE_VAL);
  }
  return fastest;
}

/// v_(n+1/2) from the forces at x_n, then x_(n+1). Returns the largest nodal speed; infinite once one is not
/// finite.
double advance_sheet(const Model& model, State& s, double dt)
{
  const double kick = 0.5 * (s.last_dt + dt);
  const MovingNodes nodes{s.position, s.velocity, s.force, model.mass};
  std::atomic<double> fastest_squared{0.0};
  parallel_ranges(static_cast<std::ptrdiff_t>(s.position.size()), [&](auto begin, auto end) {
    raise(fastest_squared, model.mass_damping > 0.0
                               ? move_through_drag(model, s, begin, end, kick, dt)
                               : kick_and_drift(nodes.part(static_cast<std::size_t>(begin), static_cast<std::size_t>(end)), kick, dt));
  });
  s.time += dt;
  s.last_dt = dt;
  ++s.step;
  return std::sqrt(fastest_squared);
}

/// Nodes on a mirror plane stay on it.
void hold_on_mirrors(const Blank& blank, State& s)
{
  for (const int n : blank.mirror_x) s.force[n].x = 0.0;
  for (const int n : blank.mirror_y) s.force[n].y = 0.0;
}

} // namespace

void evaluate_forces(const Model& model, System& s, double dt, Phases& phases)
{
  membrane_forces(model.membrane, s.sheet, dt);
  phases.mark(Phase::membrane);
  assemble(model.membrane.blocks, s.sheet.block_force, s.sheet.force);
  phases.mark(Phase::assembly);
  for (std::size_t i = 0; i < model.bending.size(); ++i) {
    bending_forces(model.bending[i], s.bending[i], s.sheet, dt);
    phases.mark(Phase::bending);
  }
  for (const Gravity& gravity : model.gravity) gravity.add(s.sheet.force);
  for (std::size_t i = 0; i < model.pressure.size(); ++i)
    pressure_forces(model.pressure[i], model.membrane, s.pressure[i], s.sheet);
  s.touched.more = contact_forces(model.contacts, model.tools, s.tools, s.contacts, model.membrane.node_area, s.touched.counted,
                                  s.sheet, dt, s.fastest * dt);
  for (ToolState& tool : s.tools) {
    tool.reaction *= model.mirror_factor;
    tool.stiffness *= model.mirror_factor;
  }
  hold_on_mirrors(model.blank, s.sheet);
  for (std::size_t i = 0; i < model.boundaries.size(); ++i)
    take_reaction(model.boundaries[i], s.boundaries[i], s.sheet);
  phases.mark(Phase::contact);
}

void step(const Model& model, System& s, double dt, Phases& phases)
{
  const double time = s.sheet.time, kick = 0.5 * (s.sheet.last_dt + dt);
  s.fastest = advance_sheet(model, s.sheet, dt);
  for (std::size_t i = 0; i < model.boundaries.size(); ++i)
    s.fastest = std::max(s.fastest, advance(model.boundaries[i], s.boundaries[i], s.sheet, time, dt));
  const std::vector<ToolState> before = s.tools;
  for (std::size_t i = 0; i < model.tools.size(); ++i) advance(model.tools[i], s.tools[i], time, dt, kick);
  phases.mark(Phase::advance);
  evaluate_forces(model, s, dt, phases);
  for (std::size_t i = 0; i < model.tools.size(); ++i)
    account_work(model.tools[i], s.tools[i], before[i].reaction,
                 s.tools[i].displacement - before[i].displacement);
}

} // namespace towform
