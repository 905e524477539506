#pragma once
#include "towform/error.hpp"
#include <CLI/CLI.hpp>

namespace towform {

/// Adds `towform run CASE.toml`, `towform resume DIR` and `towform check CASE.toml`.
void add_run_commands(CLI::App& app, ExitCode& code);

} // namespace towform
