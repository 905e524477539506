#include "output/sha256.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <algorithm>
#include <bit>
#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace towform {

namespace {

using Wide = unsigned __int128;

constexpr Wide power(Wide base, int exponent)
{
  Wide result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

/// First 32 bits of the fractional part of prime^(1/degree), in whole numbers: the standard's constants are
/// these roots (square for the initial hash, cube for the rounds), so computing them leaves no table to
/// mistype.
constexpr std::uint32_t root_bits(int prime, int degree)
{
  const Wide target = static_cast<Wide>(prime) << (32 * degree);
  Wide low = 0;
  Wide high = Wide{1} << 38; // above the root of every prime used here
  while (high - low > 1) {
    const Wide middle = (low + high) / 2;
    (power(middle, degree) <= target ? low : high) = middle;
  }
  return static_cast<std::uint32_t>(low);
}

template <std::size_t Count>
constexpr std::array<std::uint32_t, Count> roots_of_primes(int degree)
{
  std::array<std::uint32_t, Count> roots{};
  int candidate = 2;
  for (std::uint32_t& root : roots) {
    const auto is_prime = [](int n) {
      for (int d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
      return true;
    };
    while (!is_prime(candidate)) ++candidate;
    root = root_bits(candidate++, degree);
  }
  return roots;
}

constexpr auto initial_hash = roots_of_primes<8>(2);
constexpr auto round_constants = roots_of_primes<64>(3);
static_assert(initial_hash[0] == 0x6a09e667 && round_constants[63] == 0xc67178f2);

} // namespace

Sha256::Sha256() : hash_(initial_hash) {}

void Sha256::absorb(const unsigned char* block)
{
  std::array<std::uint32_t, 64> w{};
  for (std::size_t t = 0; t < 16; ++t)
    w[t] = std::uint32_t{block[4 * t]} << 24 | std::uint32_t{block[4 * t + 1]} << 16 |
           std::uint32_t{block[4 * t + 2]} << 8 | std::uint32_t{block[4 * t + 3]};
  for (std::size_t t = 16; t < 64; ++t) {
    const std::uint32_t s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3;
    const std::uint32_t s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10;
    w[t] = w[t - 16] + s0 + w[t - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = hash_; // the standard's names
  for (std::size_t t = 0; t < 64; ++t) {
    const std::uint32_t sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const std::uint32_t t1 = h + sum1 + ((e & f) ^ (~e & g)) + round_constants[t] + w[t];
    const std::uint32_t sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const std::uint32_t t2 = sum0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + t1;
    d = c;
    c = b;
    b = a;
    a = t1 + t2;
  }
  const std::array<std::uint32_t, 8> change{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) hash_[i] += change[i];
}

void Sha256::add(std::span<const unsigned char> bytes)
{
  length_ += bytes.size();
  while (!bytes.empty()) {
    const std::size_t taken = std::min(bytes.size(), block_.size() - filled_);
    std::copy_n(bytes.begin(), taken, block_.begin() + static_cast<std::ptrdiff_t>(filled_));
    filled_ += taken;
    bytes = bytes.subspan(taken);
    if (filled_ == block_.size()) {
      absorb(block_.data());
      filled_ = 0;
    }
  }
}

std::string Sha256::digest()
{
  // A one bit, zeros, and the length in bits as the last eight bytes of a block.
  const std::uint64_t bits = 8 * length_;
  std::array<unsigned char, 72> padding{0x80};
  const std::size_t zeros = (filled_ < 56 ? 56 : 120) - filled_;
  for (std::size_t i = 0; i < 8; ++i) padding[zeros + i] = static_cast<unsigned char>(bits >> (56 - 8 * i));
  add(std::span(padding).first(zeros + 8));
  std::string text;
  for (const std::uint32_t word : hash_) text += fmt::format("{:08x}", word);
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
