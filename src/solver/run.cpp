#include "towform/run.hpp"
#include "element/stable_step.hpp"
#include "output/hdf5.hpp"
#include "parallel/parallel.hpp"
#include "solver/gates.hpp"
#include "solver/memory.hpp"
#include "solver/mesh_warnings.hpp"
#include "solver/recorder.hpp"
#include "solver/run_text.hpp"
#include "solver/session_run.hpp"
#include "solver/statics_run.hpp"
#include "solver/step.hpp"
#include "solver/step_look.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace towform {

namespace {

constexpr std::int64_t steps_between_looks = 100; ///< at the stable step

/// The next steps evenly up to `time`, `most` of them. To come out one fewer they may take half of what `safety` leaves to the
/// stable step.
Stride next_stride(double time, double step, double safety, double now, std::int64_t most)
{
  const auto steps_of = [&](double dt) { return static_cast<std::int64_t>(std::ceil((time - now) / dt * (1.0 - 1e-9))); };
  const std::int64_t left = std::max(steps_of(step) - 1, steps_of(step * (0.5 + 0.5 / safety)));
  return {(time - now) / static_cast<double>(left), std::min(left, most), left <= most};
}

/// Threads that are worth waking for a sheet: a few microseconds of each step go into that, more on a busy machine.
int useful_threads(const Model& model)
{
  constexpr std::size_t elements_a_thread = 1500;
  return static_cast<int>(std::max<std::size_t>(1, model.membrane.triangles.size() / elements_a_thread));
}

class ExplicitRun final : public SessionRun {
public:
  ExplicitRun(Session& session, int thread_count)
      : SessionRun(session), model_(build_model(case_)),
        bound_(model_.membrane, SheetMass{model_.element_mass, model_.mass}, model_.shear_modulus, model_.bending)
  {
    if (thread_count == 0) set_threads(std::min(threads(), useful_threads(model_)));
    record_ = &run_.record;
    event_ = &run_.event;
    ShownCurvature curvature(model_);
    give_back_memory();
    run_.system = session.resumes() ? at_rest(model_) : start(model_);
    run_.look = model_.first_look;
    run_.record.summary.energies_J = listed(Energies{});
    session.begin(run_.record, [this](FieldVisitor& v) { visit(v, run_); });
    recorder_.emplace(case_, model_, std::move(curvature), session.directory(), run_.record);
    run_.record.summary.threads = threads();
    run_.phases.begin();
  }

private:
  [[nodiscard]] Place place() const override { return {run_.system.sheet.step, run_.system.sheet.time}; }
  [[nodiscard]] ProgressState progress() const override
  {
    const State& sheet = run_.system.sheet;
    const Summary& summary = run_.record.summary;
    return {sheet.time,
            case_.time.end,
            sheet.step,
            run_.stride.dt > 0.0 ? run_.stride.dt : sheet.last_dt,
            limiting_,
            summary.energy_error,
            summary.shear_angle_max_deg};
  }
  [[nodiscard]] std::string headline() const override
  {
    std::string text = towform::headline(case_, model_) + '\n' + mesh_warnings(case_, model_);
    text.pop_back(); // the log ends its lines itself
    return text;
  }
  [[nodiscard]] std::string closing() const override
  {
    return towform::closing(run_.record.summary, session_.directory());
  }
  void write_history() override { recorder_->history(run_.system); }
  void write_frame() override { recorder_->frame(run_.system, session_.progress()); }
  void write_last_frame() override { recorder_->last_frame(run_.system, session_.progress()); }
  void finish() override { recorder_->finish(); }

  void written() override
  {
    run_.last_output = run_.system.sheet.step;
    if (run_.stride.steps_left == 0) run_.stride = {};
    run_.phases.mark(Phase::output);
  }

  double phases(Summary& summary) const override
  {
    double stepping = 0.0;
    for (std::size_t i = 0; i < phase_names.size(); ++i) {
      const double seconds = run_.phases.seconds(static_cast<Phase>(i));
      summary.phases_s.emplace_back(phase_names[i], seconds);
      if (static_cast<Phase>(i) != Phase::output) stepping += seconds;
    }
    return stepping;
  }

  /// Whether there are so many steps between outputs that those on the way to a frame need no step of their own.
  [[nodiscard]] bool outputs_leave_room() const
  {
    constexpr double fewest_steps = 8.0;
    return case_.time.end > fewest_steps * (case_.output.history + case_.output.frames) * model_.first_step;
  }
  /// Whether no step on the way is nearer to an output, of which each has a step for itself.
  [[nodiscard]] bool is_near(double time) const
  {
    const State& sheet = run_.system.sheet;
    const Stride& stride = run_.stride;
    if (sheet.step <= run_.last_output) return false;
    return sheet.time + 0.5 * stride.dt >= time || (stride.steps_left == 1 && stride.arrives);
  }

  bool advance_to(double time, double aim) override
  {
    System& s = run_.system;
    Stride& stride = run_.stride;
    const bool on_the_way = time < aim && outputs_leave_room();
    const double goal = on_the_way ? aim : time;
    while (true) {
      while (stride.steps_left > 0) {
        if (on_the_way && is_near(time)) return true;
        step(model_, s, stride.dt, run_.phases);
        check_motion(model_, s);
        recorder_->watch(s, stride.dt);
        if (--stride.steps_left == 0 && stride.arrives) s.sheet.time = goal;
        if (s.touched.more && stride.steps_left > 0) stride = {}; // the step may be too long
        if (session_.stops_after(s.sheet.step, s.sheet.time)) return false;
      }
      session_.progress().update(progress());
      if (stride.arrives) return true;
      KnownStep& known = run_.known;
      if (known.at < 0 || s.sheet.step - known.at >= steps_between_looks || s.touched.more) {
        const StableStep present = look_at_step(model_, bound_, s, run_.look);
        known = {present.step, s.sheet.step};
        limiting_ = present.element;
      }
      stride = next_stride(goal, known.step, model_.safety, s.sheet.time, known.at + steps_between_looks - s.sheet.step);
      run_.phases.mark(Phase::stable_step);
    }
  }

  Model model_;
  StepBound bound_;
  std::optional<int> limiting_; ///< element of the step at the last look
  RunState run_;
  std::optional<Recorder> recorder_;
};

RunOutcome go(Session& session, int thread_count)
{
  if (session.the_case().solver == SolverKind::implicit) return run_statics(session);
  set_threads(thread_count);
  return ExplicitRun(session, thread_count).go();
}

/// A run that has ended well leaves no checkpoint. What cannot be read is not done: another run may be writing it.
bool is_done(const std::filesystem::path& directory)
{
  std::error_code ignored;
  const std::filesystem::path results = directory / "results.h5";
  if (!std::filesystem::exists(results, ignored) ||
      std::filesystem::exists(checkpoint_path(directory), ignored))
    return false;
  try {
    const hdf5::File file = hdf5::File::open(results, hdf5::File::Mode::read);
    return hdf5::text_attribute(file.id(), "status") == "done";
  } catch (const FileError&) {
    return false;
  }
}

} // namespace

RunOutcome run(const Case& c, const RunOptions& options)
{
  Session session(c, options);
  return go(session, options.threads);
}

RunOutcome resume(const RunOptions& options)
{
  if (is_done(options.directory)) {
    if (!options.quiet) fmt::print("{}: the run is done\n", options.directory.string());
    RunOutcome outcome;
    outcome.summary.status = "done";
    return outcome;
  }
  Session session(options);
  return go(session, options.threads);
}

} // namespace towform
