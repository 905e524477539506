#pragma once
#include "element/membrane.hpp"
#include "mesh/elements_of_node.hpp"
#include "towform/case.hpp"
#include "towform/state.hpp"
#include <vector>

namespace towform {

/// A pressure p(t) on one face of the sheet, always square to it: a triangle with corners a, b, c, counter-
/// clockwise seen from +z at the start, bears -p (b - a) x (c - a) / 2, a third of it at each corner. Its
/// stiffness, of the order of p times an edge, is far below the yarns' and left out of the stable step.
struct Pressure {
  std::vector<PressurePoint> table; ///< ascending in time; held before the first and after the last point
  ElementsOfNode elements;

  [[nodiscard]] double at(double time) const; ///< [Pa]
};

/// What changes of a pressure.
struct PressureState {
  std::vector<Vec3> force; ///< n, at t_n [N]
  double work = 0.0;       ///< done on the sheet up to t_n, by the trapezoid rule [J]
};

/// Adds the pressure's forces at x_n to s.force and completes its work over the last step.
void pressure_forces(const Pressure& pressure, const Membrane& membrane, PressureState& p, State& s);

} // namespace towform
