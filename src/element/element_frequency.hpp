#pragma once
#include "element/membrane_lanes.hpp"

namespace towform {

/// Stiffnesses that an element has by itself: of the spring to its strips and dN/dtheta [N/m].
struct OwnStiffness {
  double spring, shear;
};

/// omega^2 [1/s^2] of elements' own springs and shear, bounded by the sum of both, at the yarn vectors of places first,
/// first + 1, ... and the batch's sines. `mass` of each element [kg].
void element_frequencies(const MembraneCoefficients& c, const OwnStiffness& stiffness, const BlockLanes& lanes, int first,
                         int count, const MembraneBatch& b, const double* mass, double* squared);

} // namespace towform
