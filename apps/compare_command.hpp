#pragma once
#include "towform/error.hpp"
#include <CLI/CLI.hpp>

namespace towform {

/// Adds `towform compare RESULTS.h5 REFERENCE.csv`; sets the code to `comparison` when out of tolerance.
void add_compare_command(CLI::App& app, ExitCode& code);

} // namespace towform
