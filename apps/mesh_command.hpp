#pragma once
#include <CLI/CLI.hpp>

namespace towform {

/// `towform mesh SHAPE --part PART [--parameter value]... -o FILE.stl`: a subcommand for every tool shape, an
/// option for every parameter of it.
void add_mesh_command(CLI::App& app);

} // namespace towform
