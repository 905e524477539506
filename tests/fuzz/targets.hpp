#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace towform::fuzz {

/// A reader of files from outside, given any file. Its documented exceptions are caught; anything else that
/// happens is a finding.
struct Target {
  const char* name; ///< of its folder in corpus/
  void (*read)(const std::filesystem::path& file);
};
const std::vector<Target>& targets();

/// Writes bytes to a file of their own in memory, where there is such a place, and reads it.
void give(const Target& target, std::span<const unsigned char> bytes);

} // namespace towform::fuzz
