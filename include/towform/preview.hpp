#pragma once
#include "towform/case.hpp"
#include <filesystem>

namespace towform {

/// Writes into a directory what a run of the case would start from, as results of one frame with status
/// "preview": sheet, yarns and tools in their places, for `write_report` and everything else that reads
/// results. Throws InputError as a run does, and FileError when the directory holds earlier results, unless
/// `force`.
void write_preview(const Case& c, const std::filesystem::path& directory, bool force);

} // namespace towform
