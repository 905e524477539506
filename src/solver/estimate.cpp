#include "solver/estimate.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

/// Wall time of a step of an element on one thread, contact and all [s]: the double dome took 38 ns on an AMD EPYC, and takes
/// some 50 on the machine of docs/benchmarks.md; bending, most of the time held, adds some 3.
constexpr double element_step = 45e-9, bending_step = 3e-9;
/// Threads wait for each other: of each further one this part counts (measured with two, assumed for more).
constexpr double further_thread = 0.85;
/// Peak memory: 85 MB with 21,672 triangles over the whole press; with more from docs/benchmarks.md, its first steps, to which a
/// measurement of the stable step adds some 60 bytes an element (counted).
constexpr double memory_alone = 75e6, memory_element = 430.0; // [bytes]

std::string shown_time(double seconds)
{
  if (seconds < 100.0) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  return seconds < 6000.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.1f} h", seconds / 3600.0);
}

} // namespace

RunEstimate estimate(const Case& c, const Model& model, int threads)
{
  const auto elements = static_cast<double>(model.membrane.triangles.size());
  const double steps = std::ceil(c.time.end / model.first_step);
  const double speed = 1.0 + further_thread * (threads - 1);
  const double step = element_step + (model.bending.empty() ? 0.0 : bending_step);
  return {elements * steps * step / speed, memory_alone + memory_element * elements};
}

std::string estimate_text(const RunEstimate& e)
{
  return fmt::format(
      "estimate: {} of wall time, {:.0f} MB of memory; contact, the machine and what else it does "
      "decide\n",
      shown_time(e.wall_time), 1e-6 * e.memory);
}

} // namespace towform
