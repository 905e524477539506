#pragma once
#include "units.hpp"
#include <limits>
#include <string>

namespace towform {

/// The values a key may have, from the text the reference shows: "> 0", ">= 0", "0 .. 1", "> 0, <= 1",
/// "1 um .. 100 mm"; empty for all. Throws std::logic_error when the text says none of these.
class Range {
public:
  Range(std::string text, Dimension dimension);
  [[nodiscard]] bool contains(double value) const;
  [[nodiscard]] const std::string& text() const { return text_; }

private:
  void limit(const std::string& part, Dimension dimension);

  std::string text_;
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  bool without_low_ = false, without_high_ = false;
};

} // namespace towform
