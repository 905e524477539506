#include "report/quantised.hpp"
#include <algorithm>
#include <cmath>
#include <libdeflate.h>
#include <limits>
#include <memory>
#include <new>

namespace towform {

ComponentRanges::ComponentRanges(std::size_t components)
    : low_(components, std::numeric_limits<double>::infinity()),
      high_(components, -std::numeric_limits<double>::infinity())
{
}

void ComponentRanges::add(std::span<const double> values)
{
  const std::size_t components = low_.size();
  for (std::size_t c = 0; c < components; ++c) {
    double low = low_[c], high = high_[c];
    for (std::size_t i = c; i < values.size(); i += components) {
      if (!std::isfinite(values[i])) continue;
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
    low_[c] = low;
    high_[c] = high;
  }
}

Quantised ComponentRanges::scale() const
{
  Quantised quantised;
  for (std::size_t c = 0; c < low_.size(); ++c) {
    const bool some = low_[c] <= high_[c];
    quantised.offset.push_back(some ? low_[c] : 0.0);
    quantised.step.push_back(some ? (high_[c] - low_[c]) / (Quantised::missing - 1) : 0.0);
  }
  return quantised;
}

void add_frame(Quantised& quantised, std::span<const double> values)
{
  const std::size_t components = quantised.offset.size(), begin = quantised.q.size();
  quantised.q.resize(begin + values.size(), Quantised::missing);
  for (std::size_t c = 0; c < components; ++c) {
    const double offset = quantised.offset[c], step = quantised.step[c];
    for (std::size_t i = c; i < values.size(); i += components) {
      if (!std::isfinite(values[i])) continue;
      const double q = step > 0.0 ? std::floor((values[i] - offset) / step + 0.5) : 0.0;
      quantised.q[begin + i] = static_cast<std::uint16_t>(std::clamp(q, 0.0, Quantised::missing - 1.0));
    }
  }
}

std::string packed(std::span<const std::uint16_t> numbers, std::size_t row, std::size_t frame)
{
  std::vector<unsigned char> bytes(2 * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t back = i >= frame ? frame : row;
    const std::uint16_t before = i >= back ? numbers[i - back] : std::uint16_t{0};
    const auto difference = static_cast<std::int16_t>(static_cast<std::uint16_t>(numbers[i] - before));
    const auto folded = static_cast<std::uint16_t>((difference << 1) ^ (difference >> 15));
    bytes[i] = static_cast<unsigned char>(folded & 0xff);
    bytes[numbers.size() + i] = static_cast<unsigned char>(folded >> 8);
  }
  return base64(deflated(bytes));
}

std::string packed(std::span<const std::uint32_t> numbers)
{
  std::vector<unsigned char> bytes;
  bytes.reserve(4 * numbers.size());
  std::uint32_t before = 0;
  for (const std::uint32_t number : numbers) {
    const std::uint32_t difference = number - before;
    before = number;
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<unsigned char>(difference >> shift & 0xff));
  }
  return base64(deflated(bytes));
}

std::vector<unsigned char> deflated(std::span<const unsigned char> bytes)
{
  constexpr int level = 3; // at 6 a page is 1.5 % smaller and takes a quarter longer
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(level), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::vector<unsigned char> result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  result.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size()));
  return result;
}

std::string base64(std::span<const unsigned char> bytes)
{
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

} // namespace towform
