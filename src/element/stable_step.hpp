#pragma once
#include "element/bending.hpp"
#include "element/membrane.hpp"
#include <span>

namespace towform {

/// Which entity limits the time step, and to what.
struct StableStep {
  double step = 0.0; ///< [s]
  int element = 0;   ///< one of the elements whose yarns or shear set the limit
};

/// Stable steps of central differences on a sheet, without contact. The stiffness is a sum over patches
/// (averaged yarns: the elements round a node; own strains and shear: one element); each patch is compared
/// with the share of the elements' lumped mass it is given, and the largest frequency of the whole is at most
/// the sum of the patches' largest squares. Patches at the blank's edge, being stiffer, are given more of the
/// mass. Yarn directions are taken as equal over a patch. Damping lowers the step to 2/omega (sqrt(1 +
/// xi^2) - xi). Bending adds its own bound (Bending::frequency_bound), that of the flat sheet: what its
/// moments add as the sheet turns is of the order of curvature times element, and left out.
class StepBound {
public:
  /// `element_mass` [kg]; `shear_modulus` bounds dN/dtheta [N/m]. The membrane must outlive the bound.
  StepBound(const Membrane& membrane, std::span<const double> element_mass, double shear_modulus,
            std::span<const Bending> bending = {});

  /// The stable step at the sheet's current shape.
  [[nodiscard]] StableStep at(const State& s) const;

  /// Factors on the elements' mass (at least 1) with which the step reaches `wanted` [s] at the current
  /// shape.
  [[nodiscard]] std::vector<double> mass_factors(const State& s, double wanted) const;

private:
  struct Sums { ///< over the nodes of a patch, of products of its gradients, over their share of mass [1/(m^2
                ///< kg)]
    double warp = 0.0, weft = 0.0, both = 0.0;
  };
  struct Frequencies {
    std::vector<double> patch, element; ///< omega^2 [1/s^2]
  };
  [[nodiscard]] Sums patch_sums(std::size_t node, std::span<const double> share) const;
  [[nodiscard]] double patch_frequency(std::size_t node, double sine) const;
  [[nodiscard]] double element_frequency(const State& s, std::size_t element) const;
  [[nodiscard]] Frequencies frequencies(const State& s) const;
  [[nodiscard]] double step_of(double in_plane, double of_bending) const;

  const Membrane& membrane_;
  std::vector<double> element_mass_;
  double shear_modulus_;
  std::vector<Sums> patch_;
  std::vector<double> bending_; ///< n, omega^2 [1/s^2]; empty without bending
  double bending_damping_time_ = 0.0;
};

} // namespace towform
