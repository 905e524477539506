#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace towform {

/// The commands of a command, in the order in which help shows them.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// Completion of commands, options and, after --set, keys of a case, from the same tables as the program's
/// help.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

} // namespace towform
