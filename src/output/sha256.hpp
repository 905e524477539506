#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace towform {

/// SHA-256 (FIPS 180-4) of bytes that arrive in pieces.
class Sha256 {
public:
  Sha256();
  void add(std::span<const unsigned char> bytes);
  /// Digest of everything added, 64 lower-case hexadecimal digits; nothing may be added afterwards.
  std::string digest();

private:
  void absorb(const unsigned char* block);

  std::array<std::uint32_t, 8> hash_;
  std::array<unsigned char, 64> block_{};
  std::size_t filled_ = 0;   ///< bytes waiting in block_
  std::uint64_t length_ = 0; ///< bytes added
};

} // namespace towform
