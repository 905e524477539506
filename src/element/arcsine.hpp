#pragma once
#include <cmath>

namespace towform {

/// asin(x) for |x| <= 1 within two units in the last place, without branches or calls, so that loops over it vectorise: above 1/2
/// as pi/2 - 2 asin(sqrt((1 - x)/2)); below, (asin(s)/s - 1)/s^2 is a Chebyshev polynomial in s^2, 6e-17 off.
inline double arcsine(double x)
{
  const double size = std::abs(x);
  const bool large = size > 0.5;
  const double z = large ? 0.5 * (1.0 - size) : size * size;
  const double root = std::sqrt(z);
  const double s = large ? root : size;
  double p = 0.028169219556187758;
  p = p * z - 0.010749051836852685;
  p = p * z + 0.01603551486638625;
  p = p * z + 0.007802949444672845;
  p = p * z + 0.011875494355987582;
  p = p * z + 0.013929652911087833;
  p = p * z + 0.017355259954491768;
  p = p * z + 0.022372047631853118;
  p = p * z + 0.030381947367093046;
  p = p * z + 0.0446428571034238;
  p = p * z + 0.07500000000020764;
  p = p * z + 0.1666666666666665;
  const double small = s + s * (z * p);
  constexpr double half_pi = 1.57079632679489661923;
  return std::copysign(large ? half_pi - 2.0 * small : small, x);
}

} // namespace towform
