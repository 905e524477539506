#include "run_command.hpp"
#include "case/units.hpp"
#include "towform/preview.hpp"
#include "towform/report.hpp"
#include "towform/run.hpp"
#include <csignal>
#include <fmt/format.h>

namespace towform {

namespace {

volatile std::sig_atomic_t signal_seen = 0;

/// The first signal lets the step end; an interrupt from the keyboard after it does not wait.
extern "C" void note_signal(int signal)
{
  if (signal == SIGINT && signal_seen != 0) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
  signal_seen = signal;
}

void watch_signals()
{
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) ::sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is an error of the write, which says so
}

/// What `run` and `check` share.
struct CaseArguments {
  std::string path;
  std::vector<std::string> overrides;
  bool fast = false;

  void add_to(CLI::App& command)
  {
    command.add_option("case", path, "case file (TOML)")->required()->type_name("CASE.toml");
    command.add_option("--set", overrides, "replace or add a key: key.path=value, tool.NAME.key=value")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command.add_flag("--fast", fast,
                     "a first look: ten times the sheet's mass (time.mass_scaling = 10) for long steps, shear angles within "
                     "some 0.3 deg RMS where the sheet resists bending, but forces with ten times the inertia");
  }
  [[nodiscard]] Case read() const
  {
    Case its_own = read_case(path, overrides);
    constexpr double heavy = 10.0; // chosen in docs/benchmarks.md, run time against error
    if (!fast || its_own.time.mass_scaling >= heavy) return its_own;
    std::vector<std::string> faster{fmt::format("time.mass_scaling={}", heavy)};
    faster.insert(faster.end(), overrides.begin(), overrides.end()); // --set has the last word
    return read_case(path, faster);
  }
};

/// A wall time as in a case file: seconds, or with a unit.
double read_time(const std::string& text)
{
  const Quantity plain = read_quantity(text, Dimension::none);
  const Quantity time = plain.problem.empty() ? plain : read_quantity(text, Dimension::time);
  if (!time.problem.empty()) throw CLI::ValidationError("--max-wall", time.problem);
  if (!(time.value > 0.0)) throw CLI::ValidationError("--max-wall", "must be more than 0");
  return time.value;
}

/// What `run` and `resume` share.
void add_options(CLI::App& command, const std::shared_ptr<RunOptions>& options)
{
  command.add_option("--threads", options->threads, "number of threads (default: all cores)")
      ->check(CLI::Range(1, 1024));
  command
      .add_option_function<std::string>(
          "--max-wall", [options](const std::string& text) { options->controls.max_wall = read_time(text); },
          "stop with a checkpoint after this wall time, as \"30 min\" (exit code 75)")
      ->type_name("TIME");
  command
      .add_option("--max-steps", options->controls.max_steps,
                  "stop with a checkpoint after so many steps (exit code 75)")
      ->check(CLI::PositiveNumber);
  CLI::Option* quiet = command.add_flag("--quiet", options->quiet, "print nothing but errors");
  command
      .add_flag("--json-progress", options->json_progress,
                "print a line of JSON at each output in place of words: time_s, fraction, step, dt_s, ...")
      ->excludes(quiet);
}

/// The page that shows a run which has ended. The results are whole by now: what keeps it from being written
/// is said, and with code `files` where the run itself ended well.
void write_page(const RunOptions& options, ExitCode& code)
{
  try {
    const ReportOutcome page = write_report(options.directory);
    if (options.quiet || options.json_progress) return;
    for (const std::string& note : page.notes) fmt::print("{}\n", note);
    fmt::print("wrote {}\n", page.path.string());
  } catch (const FileError& e) {
    fmt::print(stderr, "towform: the results are whole, but there is no report: {}\n", e.what());
    if (code == ExitCode::done) code = ExitCode::files;
  }
}

void finish(const RunOutcome& outcome, const RunOptions& options, bool page, ExitCode& code)
{
  code = outcome.code;
  if (!outcome.summary.message.empty()) fmt::print(stderr, "towform: {}\n", outcome.summary.message);
  if (page && code != ExitCode::interrupted) write_page(options, code);
}

void add_run(CLI::App& app, ExitCode& code)
{
  CLI::App* command = app.add_subcommand("run", "form a case; writes results.h5, history.csv, summary.json");
  auto arguments = std::make_shared<CaseArguments>();
  auto options = std::make_shared<RunOptions>();
  arguments->add_to(*command);
  command->add_option("-o,--output", options->directory,
                      "directory of the results (default: out/<case name>)");
  command->add_flag("--force", options->force, "replace the results of an earlier run");
  add_options(*command, options);
  command->callback([arguments, options, &code] {
    watch_signals();
    options->controls.signal = &signal_seen;
    if (options->directory.empty())
      options->directory = std::filesystem::path("out") / std::filesystem::path(arguments->path).stem();
    const Case c = arguments->read();
    finish(run(c, *options), *options, c.output.report, code);
  });
}

void add_resume(CLI::App& app, ExitCode& code)
{
  CLI::App* command = app.add_subcommand("resume", "go on with a run that was interrupted");
  auto options = std::make_shared<RunOptions>();
  command->add_option("directory", options->directory, "directory of its results")
      ->required()
      ->type_name("DIR");
  add_options(*command, options);
  command->callback([options, &code] {
    watch_signals();
    options->controls.signal = &signal_seen;
    const RunOutcome outcome = resume(*options);
    // Nothing was left to do, unless the run was killed while it wrote its report.
    const bool is_whole = outcome.summary.steps == 0 && exists(options->directory / "report.html");
    finish(outcome, *options, !is_whole && read_case(options->directory / "case.resolved.toml").output.report, code);
  });
}

void add_check(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("check", "say what run would do, or all that it would reject");
  auto arguments = std::make_shared<CaseArguments>();
  auto directory = std::make_shared<std::string>();
  auto force = std::make_shared<bool>(false);
  auto resolved = std::make_shared<bool>(false);
  arguments->add_to(*command);
  CLI::Option* preview =
      command
          ->add_option("--preview", *directory,
                       "write sheet, yarns and tools as they start, with a report, into this directory")
          ->type_name("DIR");
  command->add_flag("--force", *force, "replace what an earlier preview or run left there")->needs(preview);
  command->add_flag("--resolved", *resolved,
                    "print the case with every key and the full paths of its files instead, as run reads it");
  command->callback([arguments, directory, force, resolved] {
    const Case c = arguments->read();
    const std::string description = describe_run(c);
    std::string text = *resolved ? resolved_case(c) : description;
    if (!directory->empty()) {
      write_preview(c, *directory, *force);
      const std::string page = write_report(*directory).path.string();
      if (!*resolved) text += fmt::format("wrote {}\n", page);
    }
    fmt::print("{}", text);
  });
}

} // namespace

void add_run_commands(CLI::App& app, ExitCode& code)
{
  add_run(app, code);
  add_resume(app, code);
  add_check(app);
}

} // namespace towform
