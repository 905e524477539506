#pragma once
#include <cmath>

namespace towform {

/// Where a convex function of one variable is least on [low, high]: golden section to a hundredth of the
/// range, then twice the vertex of the parabola through three points about the place. Exact to rounding for a
/// quadratic; otherwise the function's own value there is right to about 1e-10.
template <class F>
double minimum_of(const F& f, double low, double high)
{
  constexpr double golden = 0.6180339887498949;
  double a = low, b = high;
  double x1 = b - golden * (b - a), x2 = a + golden * (b - a);
  double f1 = f(x1), f2 = f(x2);
  while (b - a > 0.01 * (high - low)) {
    if (f1 <= f2) {
      b = x2;
      x2 = x1;
      f2 = f1;
      x1 = b - golden * (b - a);
      f1 = f(x1);
    } else {
      a = x1;
      x1 = x2;
      f1 = f2;
      x2 = a + golden * (b - a);
      f2 = f(x2);
    }
  }
  double x = 0.5 * (a + b);
  for (const double h : {5e-3 * (high - low), 5e-4 * (high - low)}) {
    const double below = f(x - h), here = f(x), above = f(x + h);
    const double bend = below - 2.0 * here + above;
    if (!(bend > 0.0)) break; // flat: any place will do
    const double move = 0.5 * h * (below - above) / bend;
    x += std::abs(move) < 3.0 * h ? move : std::copysign(3.0 * h, move);
  }
  return x < low ? low : x > high ? high : x;
}

} // namespace towform
