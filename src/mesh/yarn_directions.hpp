#pragma once
#include "towform/blank.hpp"
#include <numbers>

namespace towform {

inline constexpr double right_angle = 0.5 * std::numbers::pi;

/// Unit reference yarn directions of a blank, in its plane.
struct YarnDirections {
  Vec3 warp, weft;
};

/// From fibre_1 and fibre_2, or warp at fibre_angle against x and weft at right angles to it, exact at
/// multiples of 90 degrees.
YarnDirections yarn_directions(const BlankParameters& blank);

/// Of the warp against x [rad].
double warp_angle(const BlankParameters& blank);

/// Whether a mirror with this unit normal maps the two families of yarns to themselves or to one another.
bool mirrors_itself(const YarnDirections& yarns, const Vec3& normal);

} // namespace towform
