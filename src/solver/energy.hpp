#pragma once
#include "solver/model.hpp"
#include <string>
#include <utility>
#include <vector>

namespace towform {

/// The energy account of the whole sheet and its tools at t_n [J]. Yarn, shear_elastic, bending, contact and
/// kinetic are stored now; the rest has gone, or come in, since the start.
struct Energies {
  double kinetic = 0.0;          ///< sheet, without nodes held by boundaries, and force-driven tools
  double yarn = 0.0;             ///< stretched yarns
  double shear_elastic = 0.0;    ///< springs of the shear law; all of it for laws that store
  double shear_dissipated = 0.0; ///< matrix flow
  double bending = 0.0;          ///< bent yarns
  double bending_damping = 0.0;  ///< lost in bending
  double contact = 0.0;          ///< penalty and stick springs
  double friction = 0.0;         ///< lost in slip
  double damping = 0.0;          ///< lost in yarn, mass and contact damping
  double external = 0.0;         ///< work of whatever drives tools and boundaries, and of gravity

  /// Stored and lost in the sheet, without kinetic.
  [[nodiscard]] double internal() const
  {
    return yarn + shear_elastic + shear_dissipated + bending + bending_damping + contact + friction + damping;
  }
  /// What the account fails to explain, over the external work (or over all that moved, if that is more).
  [[nodiscard]] double error() const;
};

Energies energy_account(const Model& model, const System& s);

/// (kind, value) in the order of the history's columns.
std::vector<std::pair<std::string, double>> listed(const Energies& e);

} // namespace towform
