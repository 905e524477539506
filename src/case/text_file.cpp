#include "text_file.hpp"
#include "towform/error.hpp"
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace towform {

namespace {

/// Offset of the first byte that is not part of a UTF-8 sequence; the text's size when all are.
std::size_t first_bad_byte(const std::string& text)
{
  std::size_t i = 0;
  while (i < text.size()) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80             ? 1
                               : (lead & 0xe0) == 0xc0 ? 2
                               : (lead & 0xf0) == 0xe0 ? 3
                               : (lead & 0xf8) == 0xf0 ? 4
                                                       : 0;
    if (length == 0 || i + length > text.size()) return i;
    for (std::size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) return i;
    }
    i += length;
  }
  return i;
}

[[noreturn]] void refuse(const SourceLocation& where, const std::string& message)
{
  throw InputError({{where, message, ExitCode::files}});
}

} // namespace

std::string read_text(const std::filesystem::path& path, const std::string& what)
{
  constexpr std::size_t limit = 10'000'000; // a case is a few kB: anything larger is the wrong file
  const SourceLocation file{path.string(), 0, 0};
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(file, "is a directory, not a " + what);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse(file, "cannot read the " + what + ": " + std::strerror(errno));
  std::string text;
  std::array<char, 65536> part{};
  while (stream && text.size() <= limit) {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) refuse(file, "cannot read the " + what + ": " + std::strerror(errno));
  if (text.size() > limit) refuse(file, "is larger than 10 MB: not a " + what);
  if (const std::size_t bad = first_bad_byte(text); bad < text.size()) {
    SourceLocation where{file.file, 1, 1};
    for (std::size_t i = 0; i < bad; ++i) {
      where.column = text[i] == '\n' ? 1 : where.column + 1;
      if (text[i] == '\n') ++where.line;
    }
    refuse(where, "is not UTF-8 text: not a " + what);
  }
  return text;
}

} // namespace towform
