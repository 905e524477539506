#include "mesh/yarn_directions.hpp"
#include <cmath>
#include <numbers>

namespace towform {

namespace {

constexpr double tolerance = 1e-9; // of directions, and rad

/// Cosine and sine, exact at multiples of 90 degrees.
Vec3 direction(double angle)
{
  if (std::abs(std::remainder(angle, right_angle)) > tolerance)
    return {std::cos(angle), std::sin(angle), 0.0};
  constexpr Vec3 exact[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}};
  const double quarters = std::remainder(std::round(angle / right_angle), 4.0); // -2 … 2
  return exact[(static_cast<int>(quarters) + 4) % 4];
}

/// Lies along the same line?
bool along(const Vec3& a, const Vec3& b) { return norm(cross(a, b)) <= tolerance; }

} // namespace

YarnDirections yarn_directions(const BlankParameters& blank)
{
  if (blank.fibre_1 && blank.fibre_2) return {normalized(*blank.fibre_1), normalized(*blank.fibre_2)};
  const Vec3 warp = direction(blank.fibre_angle);
  return {warp, {0.0 - warp.y, warp.x, 0.0}};
}

double warp_angle(const BlankParameters& blank)
{
  return blank.fibre_1 ? std::atan2(blank.fibre_1->y, blank.fibre_1->x) : blank.fibre_angle;
}

bool mirrors_itself(const YarnDirections& yarns, const Vec3& normal)
{
  const auto mirrored = [&](const Vec3& v) { return v - (2.0 * dot(v, normal)) * normal; };
  const Vec3 warp = mirrored(yarns.warp), weft = mirrored(yarns.weft);
  return (along(warp, yarns.warp) && along(weft, yarns.weft)) ||
         (along(warp, yarns.weft) && along(weft, yarns.warp));
}

} // namespace towform
