#include "material/own_law.hpp"
#include "material/require.hpp"
#include "material/shear_resistance.hpp"
#include "towform/shear_law.hpp"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace towform {

double ShearLaw::tangent(const ShearPoint& before, const ShearPoint& after, double dt) const
{
  constexpr double span = 1e-6; // rad: cube root of a double's rounding, where differences are best
  ShearPoint low = before, high = before;
  update(low, after.angle - span, dt);
  update(high, after.angle + span, dt);
  return (high.force - low.force) / (2.0 * span);
}

void use_law(Case& c, std::shared_ptr<const ShearLaw> law)
{
  if (!law) throw std::invalid_argument("use_law: there is no law");
  c.material.law = LawKind::own;
  c.material.own_law_words = law->description();
  c.material.own_law = std::move(law);
}

namespace {

/// N [N/m] after shearing from rest to theta [rad] at a constant rate [rad/s].
double driven(const ShearLaw& law, double theta, double rate)
{
  constexpr int steps = 100;
  ShearPoint p;
  for (int i = 1; i <= steps; ++i) law.update(p, theta * i / steps, theta / rate / steps);
  return p.force;
}

/// A line N = modulus theta at every rate that the case's curves would have, or at one.
ShearCurves lines(const MaterialParameters& m)
{
  const double half = 0.5 * m.own_law->modulus() * curve_max_angle;
  const int count = m.curve_rate_max > m.curve_rate_min ? m.curve_count : 1;
  ShearCurves result;
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    const double rate = m.curve_rate_min + share * (m.curve_rate_max - m.curve_rate_min);
    result.curves.push_back(ShearCurve::from_powers(rate, curve_max_angle, {half, half}, 0.0));
  }
  return result;
}

} // namespace

FabricMaterial own_material(const MaterialParameters& m)
{
  if (!m.own_law)
    throw std::domain_error(
        fmt::format("law \"own\" ({}) belongs to a program that calls towform as a library; "
                    "this one has it not",
                    m.own_law_words));
  const ShearLaw& law = *m.own_law;
  require(law.modulus() > 0.0, "modulus of the program's own shear law", "be greater than 0", law.modulus(),
          "N/m");
  FabricMaterial result;
  result.law = OwnLaw{m.own_law};
  result.curves = std::make_shared<const ShearCurves>(lines(m));
  result.surface = std::make_shared<const ShearTable>(
      [&](double theta, double rate) { return theta > 0.0 ? driven(law, theta, rate) : 0.0; },
      ShearResistance::max_angle);
  const float* forces = result.surface->forces();
  constexpr int points = (ShearTable::angle_cells + 1) * ShearTable::rate_points;
  const float* odd = std::find_if_not(forces, forces + points, [](float f) { return std::isfinite(f); });
  if (odd != forces + points) {
    const auto place = odd - forces, row = place / ShearTable::rate_points;
    throw std::domain_error(
        fmt::format("the program's own shear law ({}) gives no finite force at {:.4g} deg and {:.4g} rad/s",
                    law.description(),
                    result.surface->max_angle() * 180.0 / M_PI / ShearTable::angle_cells *
                        static_cast<double>(row),
                    ShearTable::rate_of(place % ShearTable::rate_points)));
  }
  return result;
}

} // namespace towform
