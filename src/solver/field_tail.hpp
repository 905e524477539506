#pragma once
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace towform {

/// The upper end of a field's values.
struct FieldTail {
  double largest = 0.0;
  std::size_t place = 0;      ///< of the largest, the first of equals
  double percentile_99 = 0.0; ///< below which 99 % lie
  double fraction_over = 0.0; ///< of them all, over a limit
};

/// Of value(0) .. value(count - 1), one at least, all finite. Keeps few of them, those above what a sample tells, and may ask for
/// each value three times.
template <class Value>
FieldTail field_tail(std::size_t count, double limit, const Value& value)
{
  constexpr std::size_t sampled = 16, of_sample = 97; // every so many values, percent of them below
  constexpr std::size_t part = 4096;
  const std::size_t highest = count - (count * 99) / 100;
  const auto nth = [](std::vector<double>& values, std::size_t n) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n), values.end());
    return values[n];
  };
  std::vector<double> some;
  some.reserve(count / sampled + 1);
  for (std::size_t i = 0; i < count; i += sampled) some.push_back(value(i));
  const double threshold = nth(some, (some.size() * of_sample) / 100);

  struct OfPart {
    double largest;
    std::size_t place, over = 0, at_threshold = 0;
    std::vector<double> above = {}; ///< the threshold
  };
  std::vector<OfPart> parts((count + part - 1) / part);
  parallel_each(static_cast<int>(parts.size()), [&](int number) {
    const std::size_t begin = static_cast<std::size_t>(number) * part, end = std::min(count, begin + part);
    OfPart its{value(begin), begin};
    for (std::size_t i = begin; i < end; ++i) {
      const double v = value(i);
      if (v > its.largest) {
        its.largest = v;
        its.place = i;
      }
      its.over += v > limit ? 1 : 0;
      its.at_threshold += v == threshold ? 1 : 0;
      if (v > threshold) its.above.push_back(v);
    }
    parts[static_cast<std::size_t>(number)] = std::move(its);
  });

  FieldTail tail{parts.front().largest, parts.front().place};
  std::size_t over = 0, at_threshold = 0;
  std::vector<double> above;
  for (const OfPart& its : parts) {
    if (its.largest > tail.largest) {
      tail.largest = its.largest;
      tail.place = its.place;
    }
    over += its.over;
    at_threshold += its.at_threshold;
    above.insert(above.end(), its.above.begin(), its.above.end());
  }
  tail.fraction_over = static_cast<double>(over) / static_cast<double>(count);
  if (above.size() >= highest) {
    tail.percentile_99 = nth(above, above.size() - highest);
  } else if (above.size() + at_threshold >= highest) {
    tail.percentile_99 = threshold;
  } else { // the sample told too much
    above.clear();
    for (std::size_t i = 0; i < count; ++i) above.push_back(value(i));
    tail.percentile_99 = nth(above, count - highest);
  }
  return tail;
}

inline FieldTail field_tail(std::span<const double> values, double limit = 0.0)
{
  return field_tail(values.size(), limit, [&](std::size_t i) { return values[i]; });
}

} // namespace towform
