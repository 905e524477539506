#include "solver/step_look.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

/// The largest of each triangle's nodes for all of them.
void spread(std::span<const Triangle> triangles, std::vector<double>& of_node)
{
  const std::vector<double> before = of_node;
  for (const Triangle& t : triangles) {
    const double most = std::max({before[t[0]], before[t[1]], before[t[2]]});
    for (const int n : t) of_node[n] = std::max(of_node[n], most);
  }
}

/// Every node may touch a tool at any time; two or more only those that do, and some rings of nodes round them: the more rings, the
/// sooner others have followed, up to the whole sheet.
void count_tools(const Model& model, System& s)
{
  constexpr int fewest = 2, most = 32;
  TouchedTools& touched = s.touched;
  touched.rings = touched.more ? 2 * touched.rings : touched.rings / 2;
  touched.rings = std::clamp(touched.rings, fewest, 2 * most);
  touched.more = false;
  std::vector<double>& counted = touched.counted;
  counted.assign(counted.size(), 0.0);
  for (const ContactState& c : s.contacts)
    for (std::size_t n = 0; n < counted.size(); ++n) counted[n] += c.normal_force[n] > 0.0 ? 1.0 : 0.0;
  for (double& tools : counted) tools = std::max(tools, 1.0);
  if (touched.rings > most)
    counted.assign(counted.size(), *std::max_element(counted.begin(), counted.end()));
  else
    for (int ring = 0; ring < touched.rings; ++ring) spread(model.membrane.triangles, counted);
}

StepLook measured(const Model& model, const System& s, double bound, double near)
{
  const StepLimit limit(model.blank, model.membrane, model.mass, model.shear_modulus, model.bending, model.tool_springs);
  return {limit.at(s.sheet.position, s.touched.counted, near), bound};
}

} // namespace

StableStep look_at_step(const Model& model, const StepBound& bound, System& s, StepLook& last)
{
  constexpr double moved = 0.015, a_little_less = 0.98;
  const StableStep stable = bound.at(s.sheet);
  if (s.touched.more || !(std::abs(stable.step - last.bound) < moved * last.bound)) {
    count_tools(model, s);
    last = measured(model, s, stable.step, a_little_less * last.over_bound() * stable.step);
  }
  const double step = std::min(model.first_step, model.safety * last.over_bound() * stable.step);
  constexpr double collapse = 0.05;
  if (!(step > collapse * model.first_step))
    throw RunStopped(
        ExitCode::stability_gate,
        fmt::format(
            "stopped at t = {:.6g} ms, step {}: the stable step fell from {:.3g} to {:.3g} s at element {}, "
            "which has collapsed",
            1e3 * s.sheet.time, s.sheet.step, model.first_step, step, stable.element));
  return {step, stable.element};
}

} // namespace towform
