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

/// Masses of a sheet [kg]. A node's is what its elements give it, a third each or otherwise.
struct SheetMass {
  std::span<const double> element; ///< m
  std::span<const double> node;    ///< n
};

/// Stable steps of central differences on a sheet, without contact. The stiffness is a sum over patches:
/// strips of yarn, and single elements (their springs and shear). A strip is a rank-one matrix k A g g^T over
/// the yarn components of its nodes' displacements; each node's mass is divided among the strips of either
/// family that meet in it, and the largest frequency of all strips together is at most the largest of them
/// alone against its share. The two yarn components of a displacement at an angle share it, at most (1 + |sin
/// theta|) each. Elements are bounded likewise, and the two bounds of omega^2 are added. Yarn directions are
/// taken as equal over a patch. Damping lowers the step to 2/omega (sqrt(1 + xi^2) - xi).
/// Bending adds its own bound (Bending::frequency_bound), that of the flat sheet: what its moments add as the
/// sheet turns is of the order of curvature times element, and left out.
class StepBound {
public:
  /// `shear_modulus` bounds dN/dtheta [N/m]. Membrane and masses must outlive the bound.
  StepBound(const Membrane& membrane, const SheetMass& mass, double shear_modulus, std::span<const Bending> bending = {});

  /// The stable step at the sheet's current shape.
  [[nodiscard]] StableStep at(const State& s) const;

  /// Factors on the elements' mass (at least 1) with which the step reaches `wanted` [s] at the current
  /// shape.
  [[nodiscard]] std::vector<double> mass_factors(const State& s, double wanted) const;

private:
  struct Frequencies {
    std::vector<double> strip, element; ///< omega^2 [1/s^2]
  };
  void share_masses();
  void find_element_frequencies(const State& s, std::vector<double>& squared) const;
  [[nodiscard]] Frequencies frequencies(const State& s) const;
  [[nodiscard]] double step_of(double in_plane, double of_bending) const;

  const Membrane& membrane_;
  SheetMass mass_;
  double least_share_ = 1.0; ///< of a node, over thirds of its elements
  double shear_modulus_;
  std::vector<double> strip_frequency_; // omega^2 of a strip of square yarns [1/s^2]
  std::vector<double> bending_;         ///< n, omega^2 [1/s^2]; empty without bending
  double bending_damping_time_ = 0.0;
};

} // namespace towform
