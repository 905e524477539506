#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace towform {

/// Numbers of several frames in 16 bits: value = offset + step q, of each component its own; q = 65535 stands
/// for what is not a finite number. The error is at most half a step, that is the range over 131068.
struct Quantised {
  static constexpr std::uint16_t missing = 65535;
  std::vector<double> offset, step; ///< of each component
  std::vector<std::uint16_t> q;     ///< frame by frame, row by row

  [[nodiscard]] double value(std::size_t i) const
  {
    const std::size_t c = i % offset.size();
    return offset[c] + step[c] * q[i];
  }
};

/// The range of each component, from whatever frames it is shown.
class ComponentRanges {
public:
  explicit ComponentRanges(std::size_t components);
  void add(std::span<const double> values); ///< row by row
  /// An empty Quantised with steps for this range.
  [[nodiscard]] Quantised scale() const;

private:
  std::vector<double> low_, high_;
};

/// Appends a frame's values.
void add_frame(Quantised& quantised, std::span<const double> values);

/// For the page: differences between frames (of the first between rows) folded to small whole numbers, low
/// bytes, then high bytes, deflated (zlib), in base64. `row` is how many numbers a row has, `frame` a frame.
std::string packed(std::span<const std::uint16_t> numbers, std::size_t row, std::size_t frame);

/// Whole numbers of 32 bits, each less the one before it, little-endian, deflated, in base64.
std::string packed(std::span<const std::uint32_t> numbers);

/// Deflates (zlib format). Throws std::bad_alloc.
std::vector<unsigned char> deflated(std::span<const unsigned char> bytes);
std::string base64(std::span<const unsigned char> bytes);

} // namespace towform
