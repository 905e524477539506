#include "output/sha256.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <array>
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <new>
#include <openssl/evp.h>
#include <system_error>

namespace towform {

namespace {
void require(bool done)
{
  if (!done) throw std::bad_alloc();
}
} // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free)
{
  require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

void Sha256::add(std::span<const unsigned char> bytes)
{
  require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1);
}

std::string Sha256::digest()
{
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned int size = 0;
  require(EVP_DigestFinal_ex(context_.get(), bytes.data(), &size) == 1);
  std::string text;
  for (const unsigned char byte : std::span(bytes).first(size)) text += fmt::format("{:02x}", byte);
  return text;
}

std::string sha256_of_file(const std::filesystem::path& path)
{
  const auto fail = [&] {
    throw FileError(
        fmt::format("{}: cannot be read: {}", path.string(), std::generic_category().message(errno)));
  };
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail();
  Sha256 sha;
  std::array<char, 65536> buffer{};
  while (file) {
    file.read(buffer.data(), buffer.size());
    if (file.bad()) fail();
    sha.add({reinterpret_cast<const unsigned char*>(buffer.data()), static_cast<std::size_t>(file.gcount())});
  }
  return sha.digest();
}

} // namespace towform
