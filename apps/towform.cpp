#include "case/float_traps.hpp"
#include "compare_command.hpp"
#include "init_command.hpp"
#include "manual_command.hpp"
#include "material_command.hpp"
#include "mesh_command.hpp"
#include "output/while_written.hpp"
#include "report_command.hpp"
#include "run_command.hpp"
#include "study_command.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include "version.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace towform;

int status(ExitCode code) { return static_cast<int>(code); }

void add_info(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("info", "say what a results file holds");
  auto path = std::make_shared<std::string>();
  command->add_option("results", *path, "results.h5")->required()->type_name("RESULTS.h5");
  command->callback([path] {
    const std::filesystem::path file = *path;
    fmt::print("{}", read_while_written(file.parent_path(), 10.0, [&] { return describe_results(file); }));
  });
}

} // namespace

int main(int argc, char** argv)
{
  trap_floats();
  CLI::App app(
      "towform forms a woven composite sheet: shear, draw-in, wrinkling and force, from a case file");
  app.set_version_flag("--version", fmt::format("towform {} ({})", version::number, version::git_hash));
  app.require_subcommand(1);
  ExitCode code = ExitCode::done;
  add_run_commands(app, code);
  add_mesh_command(app);
  add_material_command(app);
  add_info(app);
  add_compare_command(app, code);
  add_report_command(app);
  add_init_command(app);
  add_manual_commands(app);
  add_study_command(app);
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
  } catch (const CheckpointError& e) {
    fmt::print(stderr, "towform: {}\n", e.what());
    return status(ExitCode::checkpoint);
  } catch (const std::exception& e) {
    fmt::print(stderr, "towform: internal error, please report it: {}\n", e.what());
    return status(ExitCode::our_bug);
  }
}
