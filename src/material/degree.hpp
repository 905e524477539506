#pragma once
#include <numbers>

namespace towform {

inline constexpr double degree = std::numbers::pi / 180.0; ///< [rad]

} // namespace towform
