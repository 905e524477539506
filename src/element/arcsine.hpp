#pragma once
#include <cmath>

namespace towform {

/// (asin(s)/s - 1)/s^2 for s up to 1/2 from its square: a Chebyshev polynomial, 6e-17 off. In pairs: sums that wait for each other
/// fill the processor's queue.
inline double arcsine_excess(double z)
{
  const double z2 = z * z, z4 = z2 * z2;
  const double low = (0.1666666666666665 + 0.07500000000020764 * z) + z2 * (0.0446428571034238 + 0.030381947367093046 * z);
  const double middle = (0.022372047631853118 + 0.017355259954491768 * z) + z2 * (0.013929652911087833 + 0.011875494355987582 * z);
  const double high = (0.007802949444672845 + 0.01603551486638625 * z) + z2 * (-0.010749051836852685 + 0.028169219556187758 * z);
  return low + z4 * (middle + z4 * high);
}

/// asin(x) for |x| <= 1/2, the same bits as arcsine(x).
inline double arcsine_to_half(double x)
{
  const double z = x * x;
  return x + x * (z * arcsine_excess(z));
}

/// asin(x) for |x| <= 1 within two units in the last place, without branches or calls, so that loops over it vectorise: above 1/2
/// as pi/2 - 2 asin(sqrt((1 - x)/2)).
inline double arcsine(double x)
{
  const double size = std::abs(x);
  // The smaller of both is the one that is wanted, and the root of a square is exact: one way for all x, as a compiler may
  // follow two, and then does everything twice.
  const double near_one = 0.5 * (1.0 - size), square = size * size;
  const double z = near_one < square ? near_one : square;
  const double s = std::sqrt(z);
  const double small = s + s * (z * arcsine_excess(z));
  constexpr double half_pi = 1.57079632679489661923;
  return std::copysign(size > 0.5 ? half_pi - 2.0 * small : small, x);
}

} // namespace towform
