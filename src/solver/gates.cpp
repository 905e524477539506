#include "solver/gates.hpp"
#include "towform/error.hpp"
#include <cmath>
#include <fmt/format.h>
#include <variant>

namespace towform {

namespace {

std::string place_of_node(const Model& model, int node)
{
  const Vec3& x = model.blank.mesh.points[node];
  return fmt::format("node {} (x = {:.1f}, y = {:.1f} mm on the flat blank)", node, 1e3 * x.x, 1e3 * x.y);
}

std::string place_of_element(const Model& model, int element)
{
  Vec3 centre;
  for (const int n : model.membrane.triangles[element]) centre += (1.0 / 3.0) * model.blank.mesh.points[n];
  return fmt::format("element {} (x = {:.1f}, y = {:.1f} mm on the flat blank)", element, 1e3 * centre.x,
                     1e3 * centre.y);
}

[[noreturn]] void stop(ExitCode code, const System& s, const std::string& what)
{
  throw RunStopped(
      code, fmt::format("stopped at t = {:.6g} ms, step {}: {}", 1e3 * s.sheet.time, s.sheet.step, what));
}

/// What to change about a penetration: a tool that moves by much of the limit in a step comes in unresisted.
std::string way_out(const DeepestContact& deepest, double limit)
{
  constexpr double much = 0.25;
  if (deepest.moved < much * limit) return "raise contact.penalty or refine the blank";
  return fmt::format("the tool moved {:.3g} mm in that step: press more slowly or scale the mass less",
                     1e3 * deepest.moved);
}

/// Fractions of the run before which ratios of small energies say nothing.
constexpr double energy_from = 0.25, kinetic_from = 0.5;

/// Whether the viscous law's spring is softer than by default, which lets steps be longer.
bool has_soft_spring(const Model& model)
{
  constexpr double by_default = 0.1; // of the yarns' stiffness
  const auto* law = std::get_if<ViscousLaw>(&model.material.law);
  return law != nullptr && law->modulus < 0.999 * by_default * model.membrane.yarn.stiffness;
}

} // namespace

void check_motion(const Model& model, const System& s)
{
  const double wave_speed = model.wave_speed;
  for (std::size_t i = 0; i < s.tools.size(); ++i)
    if (!(std::abs(s.tools[i].velocity) < wave_speed)) // it could pass through the sheet between two steps
      stop(
          ExitCode::stability_gate, s,
          fmt::format("tool '{}' moves at {:.3g} m/s, faster than waves in the yarns ({:.3g} m/s): check its "
                      "motion or force",
                      model.tools[i].name, std::abs(s.tools[i].velocity), wave_speed));
  if (s.fastest < wave_speed) return;
  int node = 0;
  for (std::size_t n = 0; n < s.sheet.velocity.size(); ++n) {
    const double speed = norm(s.sheet.velocity[n]);
    if (!(speed <= norm(s.sheet.velocity[node]))) node = static_cast<int>(n);
    if (!std::isfinite(speed)) break;
  }
  stop(ExitCode::stability_gate, s,
       fmt::format("{} moves at {:.3g} m/s, faster than waves in the yarns ({:.3g} m/s): the integration is "
                   "unstable; lower time.safety or contact.penalty",
                   place_of_node(model, node), norm(s.sheet.velocity[node]), wave_speed));
}

void check_gates(const GateParameters& gates, const Model& model, const System& s, const Energies& energies,
                 const FieldExtremes& extremes, const DeepestContact& deepest, double fraction,
                 double kinetic_ratio)
{
  // Written so that what is not a number passes none of them.
  if (!(deepest.depth <= gates.penetration))
    stop(ExitCode::contact_gate, s,
         fmt::format(
             "{} was {:.3g} mm inside tool '{}' at t = {:.6g} ms, limit gates.penetration = {:.3g} mm; {}",
             place_of_node(model, deepest.node), 1e3 * deepest.depth,
             model.tools[model.contacts[deepest.contact].tool].name, 1e3 * deepest.time,
             1e3 * gates.penetration, way_out(deepest, gates.penetration)));
  if (fraction >= energy_from && !(energies.error() <= gates.energy_error))
    stop(ExitCode::stability_gate, s,
         fmt::format("the energy account is off by {:.2f} % of the external work, limit gates.energy_error = "
                     "{:.2f} %; "
                     "{}{}lower contact.penalty, which stiffens impacts, or time.safety",
                     100.0 * energies.error(), 100.0 * gates.energy_error,
                     has_soft_spring(model) ? "leave out material.relaxation_ratio, or " : "",
                     model.lumped ? "go without time.lumping, or " : ""));
  if (fraction >= kinetic_from && !(kinetic_ratio <= gates.kinetic_to_internal))
    stop(
        ExitCode::stability_gate, s,
        fmt::format(
            "kinetic energy is {:.1f} % of internal and dissipated energy, limit gates.kinetic_to_internal = "
            "{:.1f} %: press more slowly or scale the mass less",
            100.0 * kinetic_ratio, 100.0 * gates.kinetic_to_internal));
  if (!(extremes.strain_p99 <= gates.yarn_strain))
    stop(ExitCode::stability_gate, s,
         fmt::format("1 % of the elements strain their yarns by more than {:.2f} %, limit gates.yarn_strain "
                     "= {:.2f} %; "
                     "the worst is {} with {:.2f} %",
                     100.0 * extremes.strain_p99, 100.0 * gates.yarn_strain,
                     place_of_element(model, extremes.most_strained), 100.0 * extremes.strain_max));
}

} // namespace towform
