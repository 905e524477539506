#pragma once
#include "document.hpp"
#include <filesystem>
#include <optional>

namespace towform {

/// A file that a case names, or what to tell the user when it is not there.
struct FoundFile {
  std::filesystem::path path; ///< absolute; empty when not found
  std::string problem;
};

/// Looks for a tool's mesh beside the case, in the current folder and in towform's data.
FoundFile find_mesh(const std::string& name, const std::filesystem::path& case_file);

/// Looks for a card: a path ending in .toml beside the case or in the current folder; any other name as
/// NAME.toml in cards/ beside the case, in cases/cards of the current folder and of towform's data.
FoundFile find_card(const std::string& name, const std::filesystem::path& case_file);

/// Whether towform's own data has this card under this name.
bool is_own_card(const std::filesystem::path& card);

} // namespace towform
