#include "solver/statics_increments.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

[[noreturn]] void stop(const StaticsModel& model, const StaticsState& s, double dt,
                       const NewtonReport& report)
{
  std::string where;
  if (report.worst_node >= 0) {
    const Vec3& x = model.reference[report.worst_node];
    where = fmt::format("; the largest is {:.3g} N at node {} (x = {:.1f}, y = {:.1f} mm on the flat blank)",
                        report.residual_force, report.worst_node, 1e3 * x.x, 1e3 * x.y);
  }
  std::string stability;
  if (report.negative_pivots > 0)
    stability = fmt::format("; the tangent has {} negative pivots: the sheet is not stable there",
                            report.negative_pivots);
  throw RunStopped(
      ExitCode::stability_gate,
      fmt::format("stopped at t = {:.6g} ms, increment {}: no equilibrium {:.3g} ms later, forces "
                  "left after {} iterations are {:.2g} of the elements'{}{}",
                  1e3 * s.time, s.step, 1e3 * dt, report.iterations,
                  report.residuals.empty() ? 1.0 : report.residuals.back(), where, stability));
}

} // namespace

void Increments::advance_to(double time, const StaticsModel& model, StaticsState& s,
                            const std::function<void(const NewtonReport&)>& watch)
{
  constexpr double cut = 0.25, longest_growth = 1.5, too_far = 2.0;
  while (s.time < time) {
    const double left = time - s.time;
    const double count = std::max(1.0, std::ceil(left / next_ * (1.0 - 1e-9)));
    const double dt = left / count;
    StaticsState trial = s;
    const NewtonReport report = advance(model, trial, dt);
    if (!report.converged) {
      next_ = cut * dt;
      if (next_ < controls_.shortest * run_time_) stop(model, s, dt, report);
      continue;
    }
    const double wanted = controls_.turn / std::max(trial.largest_turn, 1e-12);
    if (wanted * too_far < 1.0 && dt > controls_.shortest * run_time_) {
      next_ = 0.9 * wanted * dt;
      continue;
    }
    s = std::move(trial);
    if (count == 1.0) s.time = time;
    next_ = dt * std::min(wanted, report.iterations <= controls_.easy ? longest_growth : 1.0);
    watch(report);
  }
}

} // namespace towform
