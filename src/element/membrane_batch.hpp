#pragma once
#include "material/fabric_law.hpp"

namespace towform {

/// Some elements of a membrane side by side, so that one instruction serves several: each array has a place
/// per element. Names as in Membrane; a1 and a2 are warp and weft.
struct MembraneBatch {
  static constexpr int size = 32;
  using Lanes = double[size]; // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise

  alignas(64) Lanes d1x, d1y, d1z, d2x, d2y, d2z;   ///< edges from corner 0 [m]
  alignas(64) Lanes warp_1, warp_2, weft_1, weft_2; ///< gradients [1/m]
  alignas(64) Lanes area;                           ///< reference [m^2]
  alignas(64) Lanes f1x, f1y, f1z, f2x, f2y, f2z;   ///< unit yarn vectors
  alignas(64) Lanes lambda1, lambda2;               ///< stretches
  alignas(64) Lanes old_sine, sine;                 ///< f1 . f2
  alignas(64) Lanes old_angle, angle, rate;         ///< of the law's point
  alignas(64) Lanes old_force, force, lost;         ///< N; power dissipated over cos(theta)
  alignas(64) Lanes tension_1, tension_2;           ///< [N/m]
  alignas(64) Lanes work, dissipated;               ///< of the step [J]
  alignas(64) Lanes p1x, p1y, p1z, p2x, p2y, p2z;   ///< corner forces 1 and 2 [N]
};

/// Yarn vectors and stretches of the first `count` places.
void yarn_vectors(MembraneBatch& b, int count);

/// Sine and shear angle, counted from `reference_angle` [rad].
void shear_angles(MembraneBatch& b, int count, double reference_angle);

/// Advances the points of the viscous law by dt: the same bits as ViscousLaw::update.
void update(const ViscousLaw& law, MembraneBatch& b, int count, double dt);

/// Works of the step and corner forces.
void corner_forces(MembraneBatch& b, int count, double dt);

} // namespace towform
