#pragma once
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace towform {

/// Throws std::domain_error "NAME must RULE, not VALUE UNIT" unless `ok` and the value is a finite number.
inline void require(bool ok, const char* name, const char* rule, double value, const char* unit = "")
{
  if (ok && std::isfinite(value)) return;
  throw std::domain_error(
      fmt::format("{} must {}, not {}{}{}", name, rule, value, *unit == '\0' ? "" : " ", unit));
}

} // namespace towform
