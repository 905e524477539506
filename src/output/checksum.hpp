#pragma once
#include <cstdint>
#include <filesystem>

namespace towform {

/// CRC-32 (as of gzip) of a file's bytes from `offset` to its end. Throws FileError.
std::uint32_t crc32_of_file(const std::filesystem::path& path, std::uint64_t offset);

} // namespace towform
