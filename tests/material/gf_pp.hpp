#pragma once
#include "towform/material.hpp"

namespace towform::test {

/// The default card: typical GF/PP 2x2 twill.
inline Constituents gf_pp_twill()
{
  Constituents c;
  c.fibre_volume_fraction = 0.35;
  c.tow_width = 4.55e-3;
  c.tow_gap = 0.45e-3;
  c.fibre_diameter = 17e-6;
  c.density = 1480.0;
  c.matrix = {300.0, 0.03, 0.35, 463.15, 40e3};
  return c;
}

/// The same sheet with a matrix of constant viscosity [Pa s].
inline Constituents newtonian_twill(double viscosity)
{
  Constituents c = gf_pp_twill();
  c.matrix = {viscosity, 0.0, 0.5, 463.15, 0.0};
  return c;
}

} // namespace towform::test
