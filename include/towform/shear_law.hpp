#pragma once
#include "towform/case.hpp"
#include "towform/state.hpp"
#include <memory>
#include <string>

namespace towform {

/// A shear law that a program brings itself: how the shear force N [N/m], conjugate to sin(theta), follows
/// the shear angle. The elements of a sheet share one law and call it from several threads; what it remembers
/// of a point is in the point. Results are the same bits for any number of threads when equal arguments give
/// equal results.
class ShearLaw {
public:
  virtual ~ShearLaw() = default;

  /// Advances a point, that starts without force at angle 0, to `angle` [rad] in `dt` > 0 [s]: sets all its
  /// members. Angles may have either sign, and the steps of a run are short (some 10 us). Returns the power
  /// dissipated per area of the sheet over cos(theta): the part of N theta_dot that is not stored [W/m^2].
  virtual double update(ShearPoint& p, double angle, double dt) const = 0;

  /// Bound of dN/dtheta in any update, however short [N/m per rad], > 0: steps are stable up to it. A law
  /// with a dashpot beside its springs has none; one in series with a spring has.
  [[nodiscard]] virtual double modulus() const = 0;

  /// dN/dtheta of the update from `before` to `after` [N/m per rad], for the implicit solver; by central
  /// differences where a law knows no better.
  [[nodiscard]] virtual double tangent(const ShearPoint& before, const ShearPoint& after, double dt) const;

  /// The law with its parameters, in a line of words: recorded with the results, and a run goes on with a law
  /// of the same words only.
  [[nodiscard]] virtual std::string description() const = 0;
};

/// Puts a law in the place of the case's own: `material.law` becomes "own". Everything else of the case's
/// material still counts (yarns, density, bending).
void use_law(Case& c, std::shared_ptr<const ShearLaw> law);

} // namespace towform
