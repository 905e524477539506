#pragma once
#include <filesystem>
#include <string>

namespace towform {

/// The text of a case or card. Throws InputError (code `files`) when it is missing, a directory, unreadable,
/// larger than 10 MB or not UTF-8 (the last with its line); `what` names it in messages ("case file").
std::string read_text(const std::filesystem::path& path, const std::string& what);

} // namespace towform
