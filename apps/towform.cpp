#include "compare_command.hpp"
#include "material_command.hpp"
#include "mesh_command.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include "towform/run.hpp"
#include "version.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace towform;

int status(ExitCode code) { return static_cast<int>(code); }

/// What `run` and `check` share.
struct CaseArguments {
  std::string path;
  std::vector<std::string> overrides;

  void add_to(CLI::App& command)
  {
    command.add_option("case", path, "case file (TOML)")->required()->type_name("CASE.toml");
    command.add_option("--set", overrides, "replace or add a key: key.path=value, tool.NAME.key=value")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
  }
  [[nodiscard]] Case read() const { return read_case(path, overrides); }
};

void add_run(CLI::App& app, ExitCode& code)
{
  CLI::App* command = app.add_subcommand("run", "form a case; writes results.h5, history.csv, summary.json");
  auto arguments = std::make_shared<CaseArguments>();
  auto options = std::make_shared<RunOptions>();
  arguments->add_to(*command);
  command->add_option("-o,--output", options->directory,
                      "directory of the results (default: out/<case name>)");
  command->add_option("--threads", options->threads, "number of threads (default: all cores)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", options->quiet, "print nothing but errors");
  command->callback([arguments, options, &code] {
    if (options->directory.empty())
      options->directory = std::filesystem::path("out") / std::filesystem::path(arguments->path).stem();
    const RunOutcome outcome = run(arguments->read(), *options);
    code = outcome.code;
    if (!outcome.summary.message.empty()) fmt::print(stderr, "towform: {}\n", outcome.summary.message);
  });
}

void add_check(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("check", "say what run would do, or all that it would reject");
  auto arguments = std::make_shared<CaseArguments>();
  arguments->add_to(*command);
  command->callback([arguments] { fmt::print("{}", describe_run(arguments->read())); });
}

void add_info(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("info", "say what a results file holds");
  auto path = std::make_shared<std::string>();
  command->add_option("results", *path, "results.h5")->required()->type_name("RESULTS.h5");
  command->callback([path] { fmt::print("{}", describe_results(*path)); });
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app(
      "towform forms a woven composite sheet: shear, draw-in, wrinkling and force, from a case file");
  app.set_version_flag("--version", fmt::format("towform {} ({})", version::number, version::git_hash));
  app.require_subcommand(1);
  ExitCode code = ExitCode::done;
  add_run(app, code);
  add_check(app);
  add_mesh_command(app);
  add_material_command(app);
  add_info(app);
  add_compare_command(app, code);
  try {
    app.parse(argc, argv);
    return status(code);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : status(ExitCode::usage);
  } catch (const InputError& e) {
    fmt::print(stderr, "{}\n", e.what());
    return status(e.code());
  } catch (const FileError& e) {
    fmt::print(stderr, "towform: {}\n", e.what());
    return status(ExitCode::files);
  } catch (const std::exception& e) {
    fmt::print(stderr, "towform: internal error, please report it: {}\n", e.what());
    return status(ExitCode::our_bug);
  }
}
