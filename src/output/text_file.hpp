#pragma once
#include <cstddef>
#include <filesystem>
#include <string_view>

namespace towform {

/// Creates a directory and its parents. Throws FileError: it is a file, it cannot be created.
void make_directory(const std::filesystem::path& directory);

/// Writes a file under a temporary name beside it and renames it, so that whoever opens the file finds the
/// old text or the new one, never a part. Throws FileError naming the file; the old one then stays.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// Room is reserved before HDF5 writes: a disk that fills up while it flushes leaves a file that nobody can
/// open, and a library that crashes when the program ends. This much is for headers, attributes and grown
/// indices; a frame needs about 12 kB of them.
inline constexpr std::size_t header_bytes = 65536;

/// Makes sure that a file can grow by `bytes` (allocates them behind its end). Throws FileError, with the
/// file as it was, when the disk is full or a limit is reached.
void reserve_space(const std::filesystem::path& path, std::size_t bytes);

/// Replaces the first bytes of a file.
void overwrite_start(const std::filesystem::path& path, std::string_view text);

/// Waits until a file, or a directory's list of names, is on the disk.
void sync_file(const std::filesystem::path& path);

} // namespace towform
