#pragma once
#include <CLI/CLI.hpp>

namespace towform {

/// Adds `towform report DIR`.
void add_report_command(CLI::App& app);

} // namespace towform
