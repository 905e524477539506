#include "solver/energy.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace towform {

double Energies::error() const
{
  const double moved = std::max(std::abs(external), kinetic + internal());
  return external != 0.0 ? std::abs(kinetic + internal() - external) / moved : 0.0;
}

Energies energy_account(const Model& model, const System& s)
{
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  Energies e;
  // v_(n-1/2) . v_(n+1/2): what central differences conserve in a linear system.
  e.kinetic = parallel_sum(model.mass.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0.0;
    for (std::size_t n = begin; n < end; ++n) {
      const Vec3& v = s.sheet.velocity[n];
      part += 0.5 * (model.mass[n] * norm_squared(v) + s.sheet.last_dt * dot(v, s.sheet.force[n]));
    }
    return part;
  });
  for (std::size_t i = 0; i < s.boundaries.size(); ++i) {
    e.external += s.boundaries[i].work;
    e.kinetic -= kinetic_energy(model.boundaries[i], s.sheet, model.mass); // theirs, not the sheet's
  }
  e.yarn = model.membrane.yarn_energy(s.sheet);
  e.shear_dissipated = sum(s.sheet.shear_dissipated);
  e.shear_elastic = sum(s.sheet.shear_work) - e.shear_dissipated;
  e.damping = sum(s.sheet.yarn_damping) + sum(s.sheet.mass_damping);
  for (std::size_t i = 0; i < s.bending.size(); ++i) {
    e.bending += bending_energy(model.bending[i], s.bending[i]);
    e.bending_damping += sum(s.bending[i].damping);
  }
  for (const Gravity& gravity : model.gravity)
    e.external += gravity.work(model.blank.start_positions(), s.sheet.position);
  for (const PressureState& p : s.pressure) e.external += p.work;
  for (const ContactState& c : s.contacts) {
    e.contact += c.energies.elastic;
    e.friction += c.energies.friction;
    e.damping += c.energies.damping;
  }
  for (double* part : {&e.kinetic, &e.yarn, &e.shear_elastic, &e.shear_dissipated, &e.bending,
                       &e.bending_damping, &e.contact, &e.friction, &e.damping, &e.external})
    *part *= model.mirror_factor;
  for (std::size_t i = 0; i < s.tools.size(); ++i) {
    const Tool& tool = model.tools[i];
    e.external += s.tools[i].work;
    if (!tool.force) continue;
    e.kinetic += 0.5 * tool.mass * s.tools[i].velocity * next_velocity(tool, s.tools[i], s.sheet.last_dt);
    e.damping += s.tools[i].damped;
  }
  return e;
}

std::vector<std::pair<std::string, double>> listed(const Energies& e)
{
  return {{"kinetic", e.kinetic},
          {"yarn", e.yarn},
          {"shear_elastic", e.shear_elastic},
          {"shear_dissipated", e.shear_dissipated},
          {"bending", e.bending},
          {"bending_damping", e.bending_damping},
          {"contact", e.contact},
          {"friction", e.friction},
          {"damping", e.damping},
          {"external", e.external}};
}

} // namespace towform
