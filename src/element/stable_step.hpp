#pragma once
#include "element/membrane.hpp"
#include <span>

namespace towform {

/// Which entity limits the time step, and to what.
struct StableStep {
  double step = 0.0; ///< [s]
  int element = 0;   ///< one of the elements whose yarns or shear set the limit
};

/// A guaranteed stable step of central differences on the sheet at its current shape, without contact. The
/// stiffness is a sum over patches (averaged yarns: the elements round a node; own strains and shear: one
/// element), and each patch is compared with its share of the elements' lumped mass: the largest frequency of
/// the whole is at most the sum of the patches' largest squares. Yarn damping lowers the step to 2/omega
/// (sqrt(1 + xi^2) - xi). `element_mass` [kg]; `shear_modulus` bounds dN/dtheta [N/m].
StableStep stable_step(const Membrane& membrane, const State& s, std::span<const double> element_mass,
                       double shear_modulus);

/// Factors on the elements' mass (at least 1) with which `stable_step` reaches `wanted` [s] at the current
/// shape.
std::vector<double> selective_mass_factors(const Membrane& membrane, const State& s,
                                           std::span<const double> element_mass, double shear_modulus,
                                           double wanted);

} // namespace towform
