#pragma once
#include "material/shear_curves.hpp"
#include "material/shear_table.hpp"
#include "towform/material.hpp"
#include "towform/shear_law.hpp"
#include "towform/state.hpp"
#include <cmath>
#include <memory>
#include <variant>

namespace towform {

/// `"viscous"`: a Maxwell element, spring G in series with the sheet's own viscous surface N_s(theta, rate):
/// N + G dt rate(N) = N_old + G dtheta with N = N_s(theta, rate), solved for the rate cell by cell of the
/// table, where it is linear. The surface is concave and rising in the rate (shear thinning), so the way from
/// below is monotone; from above its first step undershoots.
struct ViscousLaw {
  std::shared_ptr<const ShearTable> surface;
  double modulus = 0.0;                  ///< G [N/m]
  static constexpr int most_rounds = 50; ///< of looking for the rate's cell; two or three are usual

  /// Advances the point to `angle`; returns the power dissipated over cos(theta), |N| rate [W/m^2].
  double update(ShearPoint& p, double angle, double dt) const
  {
    const double trial = p.force + modulus * (angle - p.angle);
    const double target = std::abs(trial), spring = modulus * dt;
    double rate = p.rate;
    for (int i = 0; i < most_rounds; ++i) {
      const auto [found, unsettled] = surface->root(angle, rate, target, spring);
      rate = found;
      if (unsettled == 0) break;
    }
    p.angle = angle;
    p.rate = rate;
    p.force = std::copysign(target - spring * rate, trial);
    return std::abs(p.force) * rate;
  }

  /// dN/dtheta of the update from `before` to `after`, by implicit differentiation of its equation [N/m per
  /// rad].
  double tangent(const ShearPoint& before, const ShearPoint& after, double dt) const
  {
    const double trial = before.force + modulus * (after.angle - before.angle);
    const double over_rate = surface->slice(after.angle).at(after.rate).slope;
    const double over_angle = std::copysign(1.0, trial) * slope_over_angle(after);
    return modulus * (over_rate + dt * over_angle) / (over_rate + modulus * dt);
  }

private:
  /// dN_s/dtheta of the table: it is linear across a cell of angles.
  [[nodiscard]] double slope_over_angle(const ShearPoint& p) const
  {
    const double cell = surface->max_angle() / ShearTable::angle_cells, place = std::abs(p.angle) / cell;
    const double low = place < ShearTable::angle_cells - 1 ? std::floor(place) : ShearTable::angle_cells - 1;
    const double rise = surface->force((low + 1.0) * cell, p.rate) - surface->force(low * cell, p.rate);
    return std::copysign(rise / cell, p.angle);
  }
};

/// `"incremental"`, the paper's: dN = dN_s/dtheta dtheta along the curve chosen by the rate (Eqs. 9-12); the
/// direction of the stress follows the yarns exactly. Whatever the curves dissipate in truth, this law
/// stores.
struct IncrementalLaw {
  std::shared_ptr<const ShearCurves> curves;
  CurveSelection selection = CurveSelection::next_higher;
  double velocity_scale = 1.0; ///< multiplies the rate where a curve is chosen

  double update(ShearPoint& p, double angle, double dt) const
  {
    const double step = angle - p.angle, middle = 0.5 * (angle + p.angle);
    p.rate = std::abs(step) / dt;
    p.force += slope(middle, p.rate * velocity_scale) * step;
    p.angle = angle;
    return 0.0;
  }

  /// dN/dtheta of the update from `before` to `after` [N/m per rad].
  double tangent(const ShearPoint& before, const ShearPoint& after, double dt) const
  {
    const double step = after.angle - before.angle, middle = 0.5 * (after.angle + before.angle);
    const double rate = after.rate * velocity_scale;
    constexpr double span = 1e-4; // the curves are smooth polynomials: exact to nine digits
    const double bend = (slope(middle + span, rate) - slope(middle - span, rate)) / (2.0 * span);
    return slope(middle, rate) + 0.5 * step * bend +
           std::abs(step) * velocity_scale / dt * slope_over_rate(middle, rate);
  }

private:
  /// How the slope changes with the rate between two curves.
  [[nodiscard]] double slope_over_rate(double angle, double rate) const
  {
    const auto count = static_cast<double>(curves->curves.size());
    const double position = curves->position(rate);
    if (selection == CurveSelection::next_higher || position <= 1.0 || position >= count) return 0.0;
    const ShearCurve* low = &curves->curves[static_cast<std::size_t>(position) - 1];
    return (low[1].slope(angle) - low[0].slope(angle)) / (low[1].rate() - low[0].rate());
  }

  [[nodiscard]] double slope(double angle, double rate) const
  {
    if (selection == CurveSelection::next_higher)
      return curves->curves[static_cast<std::size_t>(curves->next_higher(rate)) - 1].slope(angle);
    const double position = curves->position(rate) - 1.0;
    const auto low = static_cast<std::size_t>(position);
    const double weight = position - static_cast<double>(low);
    const double below = curves->curves[low].slope(angle);
    return weight == 0.0 ? below : below + weight * (curves->curves[low + 1].slope(angle) - below);
  }
};

/// `"elastic"`: one curve whatever the rate, N a function of theta alone. The curve starts at N_s(0) > 0:
/// through theta = 0 it is joined by a straight line over +-`joint`.
struct ElasticLaw {
  std::shared_ptr<const ShearCurves> curves; ///< exactly one
  static constexpr double joint = 0.5 * 3.14159265358979323846 / 180.0;

  double update(ShearPoint& p, double angle, double dt) const
  {
    const ShearCurve& curve = curves->curves.front();
    p.rate = std::abs(angle - p.angle) / dt;
    p.angle = angle;
    p.force = force(curve, curve.force(joint), angle);
    return 0.0;
  }
  /// N at an angle; without branches, for loops that vectorise.
  static double force(const ShearCurve& curve, double at_joint, double angle)
  {
    const double size = angle < 0.0 ? -angle : angle, inside = at_joint * (angle / joint);
    const double outside = std::copysign(curve.force(size), angle);
    return size < joint ? inside : outside;
  }

  /// dN/dtheta at `after` [N/m per rad].
  double tangent(const ShearPoint&, const ShearPoint& after, double) const
  {
    const ShearCurve& curve = curves->curves.front();
    return std::abs(after.angle) < joint ? curve.force(joint) / joint : curve.slope(after.angle);
  }
};

/// `"own"`: the law that the calling program brought.
struct OwnLaw {
  std::shared_ptr<const ShearLaw> law;

  double update(ShearPoint& p, double angle, double dt) const { return law->update(p, angle, dt); }
  double tangent(const ShearPoint& before, const ShearPoint& after, double dt) const
  {
    return law->tangent(before, after, dt);
  }
};

using FabricLaw = std::variant<ViscousLaw, IncrementalLaw, ElasticLaw, OwnLaw>;

/// The law of a case with its surface and curves.
struct FabricMaterial {
  FabricLaw law;
  std::shared_ptr<const ShearTable> surface;
  std::shared_ptr<const ShearCurves> curves; ///< of the case's rates: what the indicator counts
};

/// Up to where curves are fitted to a model: beyond this the surface rises like 1/cos^3 and a polynomial of
/// order 11 no longer follows it well.
inline constexpr double curve_max_angle = 75.0 * 3.14159265358979323846 / 180.0;

/// Tabulates the shear force once - the energy model's, or that of the curves or tangent that replace it
/// (material/shear_surface.hpp) - and builds the law. Throws std::domain_error (constituents out of range, a
/// law that shear_tangent cannot serve) and InputError (curve file).
FabricMaterial make_fabric_material(const MaterialParameters& material, double thickness);

} // namespace towform
