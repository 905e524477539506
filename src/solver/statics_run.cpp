#include "solver/statics_run.hpp"
#include "solver/session_run.hpp"
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

std::string headline_of(const Case& c, const StaticsCase& p)
{
  return fmt::format("{}: {} quadrilaterals, {} nodes, {} unknowns, quasi-static in the plane",
                     c.title.empty() ? "untitled" : c.title, p.grid.elements.size(), p.grid.points.size(),
                     p.model.constraints.free.cols());
}

std::string closing_of(const Summary& s, const std::filesystem::path& directory)
{
  return fmt::format("{} in {:.2f} s: {} increments\n"
                     "shear max {:.2f} deg, drive {:.3f} N, energy error {:.3f} %, yarn strain max {:.4f} %\n"
                     "wrote {}",
                     s.status, s.wall_time_s, s.steps, s.shear_angle_max_deg, s.punch_force_max_N,
                     100.0 * s.energy_error, 100.0 * s.fibre_strain_max,
                     (directory / "results.h5, results.xdmf, history.csv, summary.json, run.log").string());
}

/// Leaves the increments when the session is to stop.
struct Interrupted {};

class StaticsRun final : public SessionRun {
public:
  explicit StaticsRun(Session& session)
      : SessionRun(session), problem_(build_statics(case_)), increments_(case_.time.end)
  {
    record_ = &run_.record; // of one thread, as its summary says by default
    event_ = &run_.event;
    run_.sheet = start(problem_.model);
    run_.next_increment = increments_.next();
    run_.record.summary.energies_J = listed(Energies{});
    session.begin(run_.record, [this](FieldVisitor& v) { visit(v, run_); });
    increments_.next() = run_.next_increment;
    recorder_.emplace(case_, problem_, session.directory(), run_.record);
  }

private:
  [[nodiscard]] Place place() const override { return {run_.sheet.step, run_.sheet.time}; }
  [[nodiscard]] ProgressState progress() const override
  {
    return {run_.sheet.time,
            case_.time.end,
            run_.sheet.step,
            run_.sheet.last_dt,
            std::nullopt,
            run_.record.summary.energy_error,
            run_.record.summary.shear_angle_max_deg};
  }
  [[nodiscard]] std::string headline() const override { return headline_of(case_, problem_); }
  [[nodiscard]] std::string closing() const override
  {
    return closing_of(run_.record.summary, session_.directory());
  }
  void write_history() override
  {
    solved_ = Clock::now();
    recorder_->history(run_.sheet);
  }
  void write_frame() override { recorder_->frame(run_.sheet, session_.progress()); }
  void write_last_frame() override { write_frame(); } // the last equilibrium
  void written() override { run_.output += seconds_since(solved_); }
  void finish() override { recorder_->finish(); }
  double phases(Summary& summary) const override
  {
    summary.phases_s = {{"solve", run_.stepping}, {"output", run_.output}};
    return run_.stepping;
  }

  bool advance_to(double time, double) override
  {
    Clock::time_point before = Clock::now();
    try {
      increments_.advance_to(time, problem_.model, run_.sheet, [&](const NewtonReport& report) {
        recorder_->watch(run_.sheet, report);
        session_.progress().update(progress());
        run_.stepping += seconds_since(before);
        before = Clock::now();
        run_.next_increment = increments_.next();
        if (session_.stops_after(run_.sheet.step, run_.sheet.time)) throw Interrupted{};
      });
    } catch (const Interrupted&) {
      return false;
    }
    return true;
  }

  StaticsCase problem_;
  Increments increments_;
  StaticsRunState run_;
  std::optional<StaticsRecorder> recorder_;
  Clock::time_point solved_;
};

} // namespace

RunOutcome run_statics(Session& session) { return StaticsRun(session).go(); }

std::string describe_statics(const Case& c)
{
  const StaticsCase problem = build_statics(c);
  std::string text = headline_of(c, problem) + '\n';
  text += fmt::format("curves fit to {:.2f} %\n", 100.0 * problem.material.curves->fit_error);
  for (const HeldGroup& g : problem.model.groups)
    if (g.motion)
      text += fmt::format("boundary '{}': moves {:.4g} mm by the end\n", g.name,
                          1e3 * g.motion->displacement(c.time.end));
  return text;
}

} // namespace towform
