#pragma once
#include <CLI/CLI.hpp>

namespace towform {

/// Adds `towform manual` (the man page), `towform completion bash` or `zsh` and `towform schema`, which print what is
/// installed with the program. Man page and completion walk the program's own commands and options, and the
/// table of keys: nothing is written twice. To be added last.
void add_manual_commands(CLI::App& app);

} // namespace towform
