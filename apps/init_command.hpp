#pragma once
#include <CLI/CLI.hpp>

namespace towform {

/// Adds `towform init [DIR]`: a commented case that runs, and the schema by which editors know its keys.
void add_init_command(CLI::App& app);

} // namespace towform
