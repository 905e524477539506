#pragma once
#include <CLI/CLI.hpp>

namespace towform {

/// `towform material predict CASE` and `towform material fit TEST.csv`.
void add_material_command(CLI::App& app);

} // namespace towform
