#pragma once
#include "compare/comparison.hpp"
#include <string>

namespace towform {

/// The comparison for a reader: a line a point, those outside the sheet too, then mean, RMS, largest and the
/// verdict. Lengths in mm, angles in deg; `judged` says that there was a limit.
std::string comparison_text(const Comparison& comparison, const ReferencePoints& reference, bool judged);

/// The same as a CSV file: line, place, computed, reference, difference; outside the sheet they are empty.
std::string comparison_csv(const Comparison& comparison, const ReferencePoints& reference);

} // namespace towform
