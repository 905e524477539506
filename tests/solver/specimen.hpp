#pragma once
#include "material/gf_pp.hpp"
#include "material/shear_resistance.hpp"
#include "solver/energy.hpp"
#include "solver/model.hpp"
#include "solver/step.hpp"
#include <cmath>

namespace towform::test {

using Edge = BoundaryParameters::Edge;

/// A specimen of the default sheet, not held yet; quiet and coarse enough to run in a moment.
inline Case specimen(Vec2 size, double edge, double end)
{
  Case c;
  c.blank.size = size;
  c.blank.edge = edge;
  c.blank.thickness = 1e-3;
  c.material.constituents = gf_pp_twill();
  c.material.temperature = 463.15;
  c.material.curve_rate_min = 0.1;
  c.material.curve_rate_max = 1.0;
  c.material.curve_count = 2;
  c.material.fibre_modulus = 1e9;
  c.material.strip_stiffness = 50.0;
  c.material.compression_factor = 0.1;
  c.material.yarn_damping = 0.05;
  c.material.relaxation_ratio = 1.0;
  c.time.end = end;
  c.time.mass_scaling = 100.0;
  return c;
}

inline Motion moving(Axis axis, double displacement, double duration,
                     Motion::Profile profile = Motion::Profile::constant)
{
  Motion m;
  m.axis = axis;
  m.profile = profile;
  m.amount = displacement;
  m.duration = duration;
  return m;
}

/// Held at one edge, pulled at the opposite one.
inline Case gripped(Case c, Edge held, Edge pulled, const Motion& motion)
{
  c.boundaries.push_back({"foot", BoundaryParameters::Kind::grip, held, {}});
  c.boundaries.push_back({"head", BoundaryParameters::Kind::grip, pulled, motion});
  return c;
}

inline Case framed(Case c, const Motion& motion)
{
  c.boundaries.push_back({"frame", BoundaryParameters::Kind::picture_frame, {}, motion});
  return c;
}

/// Steps to the time with half the step of the start, so that no shape on the way is too much for it.
inline void advance_to(double time, const Model& model, System& s)
{
  Phases untimed;
  const double left = time - s.sheet.time;
  const double steps = std::ceil(2.0 * left / model.first_step);
  for (int i = 0; i < static_cast<int>(steps); ++i) step(model, s, left / steps, untimed);
}

/// Eq. 13.
inline double frame_angle(double displacement, double arm)
{
  return 0.5 * M_PI - 2.0 * std::acos(1.0 / std::sqrt(2.0) + displacement / (2.0 * arm));
}

} // namespace towform::test
