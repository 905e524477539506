#pragma once
#include <memory>
#include <span>
#include <string>

struct evp_md_ctx_st;

namespace towform {

/// SHA-256 (FIPS 180-4) of bytes that arrive in pieces, by OpenSSL. Everything throws std::bad_alloc.
class Sha256 {
public:
  Sha256();
  void add(std::span<const unsigned char> bytes);
  /// Digest of everything added, 64 lower-case hexadecimal digits; nothing may be added afterwards.
  std::string digest();

private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

} // namespace towform
