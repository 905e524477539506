#pragma once
#include <CLI/CLI.hpp>

namespace towform {

/// Adds `towform study STUDY.toml`: many runs. The studies themselves are the Python package tools/study, which
/// takes over this process.
void add_study_command(CLI::App& app);

} // namespace towform
