#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace towform {

/// The value below which 99 % lie, of value(0) .. value(count - 1), one at least. Keeps few of them,
/// those above what a sample tells, and may ask for each value three times.
template <class Value>
double percentile_99(std::size_t count, const Value& value)
{
  constexpr std::size_t sampled = 16, of_sample = 97; // every so many values, percent of them below
  const std::size_t highest = count - (count * 99) / 100;
  const auto nth = [](std::vector<double>& values, std::size_t n) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n), values.end());
    return values[n];
  };
  std::vector<double> some;
  for (std::size_t i = 0; i < count; i += sampled) some.push_back(value(i));
  const double threshold = nth(some, (some.size() * of_sample) / 100);

  std::vector<double> above;
  std::size_t at_threshold = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double v = value(i);
    if (v > threshold) above.push_back(v);
    at_threshold += v == threshold ? 1 : 0;
  }
  if (above.size() >= highest) return nth(above, above.size() - highest);
  if (above.size() + at_threshold >= highest) return threshold;
  above.clear(); // the sample told too much
  for (std::size_t i = 0; i < count; ++i) above.push_back(value(i));
  return nth(above, count - highest);
}

inline double percentile_99(std::span<const double> values)
{
  return percentile_99(values.size(), [&](std::size_t i) { return values[i]; });
}

} // namespace towform
