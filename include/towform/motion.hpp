#pragma once
#include "towform/vec3.hpp"
#include <vector>

namespace towform {

enum class Axis { x, y, z };
Vec3 unit_vector(Axis axis);

/// A prescribed movement along an axis, in time: displacement, velocity, or either from a table.
struct Motion {
  enum class Quantity { displacement, velocity };
  enum class Profile {
    constant, ///< constant speed from the first moment
    smooth,   ///< speed rises from and falls to zero (quintic)
    table,    ///< straight lines between points
  };
  struct Point {
    double time;  ///< [s]
    double value; ///< [m] or [m/s]
  };

  Axis axis = Axis::z;
  Quantity quantity = Quantity::displacement;
  Profile profile = Profile::constant;
  double amount = 0.0;      ///< final displacement [m], reached at `duration`, or the velocity [m/s]
  double duration = 0.0;    ///< end of the run [s]
  std::vector<Point> table; ///< ascending in time; held before the first and after the last point

  /// Displacement along the axis at time t [m].
  [[nodiscard]] double displacement(double t) const;
};

} // namespace towform
