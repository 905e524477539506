#pragma once
#include "towform/vec3.hpp"
#include <numbers>

namespace towform::shapes {

/// The working surface of a punch with one or two domes, apex down, analytic.
///
/// Profile: a circular arc of the dome's radius up to 90 degrees less the draft, then a straight wall. It is
/// revolved about the verticals through (+-centre, 0) and, between them, drawn along x with its width scaled
/// by w(x) = (R + waist)/2 + (waist - R)/2 cos(pi x/centre). Heights are the same in both and w' = 0 at both
/// ends, so the tangent plane is continuous everywhere.
struct DomeSurface {
  double radius = 0.0; ///< R of the domes, m
  double waist = 0.0;  ///< half-width at x = 0, m
  double centre = 0.0; ///< x of the dome's centre, m; 0: one dome, only u >= 1 exists
  double draft = 0.0;  ///< of the wall against the vertical, rad

  /// Half-width and height above the apex against s: an angle in rad on the arc, continued on the wall by
  /// length/R.
  struct Profile {
    double a, a_s;       ///< half-width over w, and its derivative
    double rise, rise_s; ///< m
  };
  [[nodiscard]] double arc_end() const { return std::numbers::pi / 2.0 - draft; }
  [[nodiscard]] Profile profile(double s) const;
  [[nodiscard]] double s_at_rise(double rise) const; ///< inverse of the profile's rise

  /// u as in `quarter.hpp`; z counts from the apex.
  [[nodiscard]] Vec3 point(double u, double s) const;
  /// Unit normal out of the punch.
  [[nodiscard]] Vec3 normal(double u, double s) const;
  /// The largest concave principal curvature up to s, 1/m (0 when convex): 1/it bounds every outward offset.
  [[nodiscard]] double concave_curvature(double s) const;
  /// The largest |w''|, 1/m: curvature of the outline between the domes.
  [[nodiscard]] double outline_curvature() const;

private:
  struct Width {
    double w, w_x, w_xx;
  };
  [[nodiscard]] Width width(double x) const;
};

} // namespace towform::shapes
