#include "solver/statics_run.hpp"
#include "output/text_file.hpp"
#include "solver/events.hpp"
#include "solver/statics_increments.hpp"
#include "solver/statics_recorder.hpp"
#include <chrono>
#include <fmt/format.h>

namespace towform {

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string headline(const Case& c, const StaticsCase& p)
{
  return fmt::format("{}: {} quadrilaterals, {} nodes, {} unknowns, quasi-static in the plane",
                     c.title.empty() ? "untitled" : c.title, p.grid.elements.size(), p.grid.points.size(),
                     p.model.constraints.free.cols());
}

std::string closing(const Summary& s, const std::filesystem::path& directory)
{
  return fmt::format("{} in {:.2f} s: {} increments\n"
                     "shear max {:.2f} deg, drive {:.3f} N, energy error {:.3f} %, yarn strain max {:.4f} %\n"
                     "wrote {}",
                     s.status, s.wall_time_s, s.steps, s.shear_angle_max_deg, s.punch_force_max_N,
                     100.0 * s.energy_error, 100.0 * s.fibre_strain_max,
                     (directory / "results.h5, results.xdmf, history.csv, summary.json, run.log").string());
}

} // namespace

RunOutcome run_statics(const Case& c, const RunOptions& options)
{
  const Clock::time_point start_of_all = Clock::now();
  const StaticsCase problem = build_statics(c);
  make_directory(options.directory);
  StaticsRecorder recorder(c, problem, options.directory);
  Progress progress(options.directory, options.quiet);
  Summary& summary = recorder.summary(); // one thread, as it says by default
  progress.line(headline(c, problem));

  RunOutcome outcome;
  StaticsState s = start(problem.model);
  Increments increments(c.time.end);
  double output = 0.0, stepping = 0.0;
  try {
    recorder.history(s);
    recorder.frame(s, progress);
    for (const Event& event : events_of(c)) {
      const Clock::time_point before = Clock::now();
      increments.advance_to(event.time, problem.model, s, [&](const NewtonReport& report) {
        recorder.watch(s, report);
        progress.update(s.time / c.time.end);
      });
      stepping += seconds_since(before);
      const Clock::time_point solved = Clock::now();
      recorder.history(s);
      if (event.frame) recorder.frame(s, progress);
      output += seconds_since(solved);
    }
    summary.status = "done";
  } catch (const RunStopped& stop) {
    outcome.code = stop.code();
    summary.status = "stopped";
    summary.message = stop.what();
    summary.steps = s.step;
    summary.simulated_time_s = s.time;
    progress.line(summary.message);
    recorder.frame(s, progress); // the last equilibrium
  }
  summary.phases_s = {{"solve", stepping}, {"output", output}};
  summary.wall_time_s = seconds_since(start_of_all);
  const double element_steps = static_cast<double>(summary.elements) * static_cast<double>(s.step);
  summary.ns_per_element_step = element_steps > 0.0 ? 1e9 * stepping / element_steps : 0.0;
  recorder.finish();
  progress.line(closing(summary, options.directory));
  outcome.summary = summary;
  return outcome;
}

std::string describe_statics(const Case& c)
{
  const StaticsCase problem = build_statics(c);
  std::string text = headline(c, problem) + '\n';
  text += fmt::format("curves fit to {:.2f} %\n", 100.0 * problem.material.curves->fit_error);
  for (const HeldGroup& g : problem.model.groups)
    if (g.motion)
      text += fmt::format("boundary '{}': moves {:.4g} mm by the end\n", g.name,
                          1e3 * g.motion->displacement(c.time.end));
  return text;
}

} // namespace towform
