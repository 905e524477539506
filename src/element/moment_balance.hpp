#pragma once
#include "element/quadratic_fit.hpp"
#include <span>
#include <vector>

namespace towform {

/// Weights of a second derivative along one direction, one a point of every node's patch.
using DirectionalWeights = std::vector<std::vector<double>>;

/// Makes second derivatives along `direction` (unit, in the plane) sum up as the divergence theorem says,
///   sum_n A_n w,ff(n) = contour integral of (nu . f) w,f ds   for every field w,
/// so that a uniform moment is carried by the edges alone and loads no node inside: without it a sheet finds
/// ways round its stiffness between the nodes and bends 5 to 50 % too easily, however fine the mesh. The
/// change is the least one, sum_n A_n r_n^4 |change|^2, that keeps quadratics exact. Solved by conjugate
/// gradients, which reach what counts (waves as short as the mesh) first: the error in stiffness is below
/// 1e-3 after 10 iterations on a mesh of any size. `area` per node [m^2]; the fits' weights are wanted on the
/// outline only. Returns what is left of the largest
/// imbalance, over its size at the start.
double balance_moments(const MirroredSheet& sheet, const SurfaceMesh& flat,
                       std::span<const QuadraticFit> fits, std::span<const double> area,
                       const Vec3& direction, int iterations, DirectionalWeights& weights);

} // namespace towform
