#include "element/element_frequency.hpp"
#include "parallel/vector_clones.hpp"
#include <cmath>

namespace towform {

TOWFORM_VECTOR_CLONES
void element_frequencies(const MembraneCoefficients& c, const OwnStiffness& stiffness, const BlockLanes& __restrict lanes,
                         int first, int count, const MembraneBatch& __restrict b, const double* mass, double* squared)
{
  const double* __restrict masses = mass;
  double* __restrict to = squared;
  const OwnStiffness own = stiffness;
  for (int i = 0; i < count; ++i) {
    const int k = first + i;
    const double warp_1 = c.warp_1[i], warp_2 = c.warp_2[i], weft_1 = c.weft_1[i], weft_2 = c.weft_2[i];
    const double warp_0 = -warp_1 - warp_2, weft_0 = -weft_1 - weft_2;
    const double warp = warp_0 * warp_0 + warp_1 * warp_1 + warp_2 * warp_2;
    const double weft = weft_0 * weft_0 + weft_1 * weft_1 + weft_2 * weft_2;
    const double both = warp_0 * weft_0 + warp_1 * weft_1 + warp_2 * weft_2;
    const double sine = b.sine[i], over_1 = lanes.over_stretch[k], over_2 = lanes.over_stretch[BlockLanes::size + k];
    const double half_off = 0.5 * (warp - weft), coupled = both * sine;
    const double yarns = own.spring * (0.5 * (warp + weft) + std::sqrt(half_off * half_off + coupled * coupled));
    const double shear = own.shear * std::sqrt(1.0 - sine * sine) *
                         (warp * over_1 * over_1 + weft * over_2 * over_2 - 2.0 * sine * both * over_1 * over_2);
    to[i] = 3.0 * c.area[i] / masses[i] * (yarns + shear);
  }
}

} // namespace towform
