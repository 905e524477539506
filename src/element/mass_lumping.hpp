#pragma once
#include "element/membrane.hpp"
#include "towform/blank.hpp"
#include <vector>

namespace towform {

/// Factors on the thirds of its triangles' masses that a node has: a `share` of the sheet's mass goes to the nodes in proportion to
/// how stiff the strips of yarn hold each (the trace of its block of K) and how heavy the elements round it are, the rest stays
/// where it is. The sheet weighs what it did, and so, to a few hundredths, does every part of it some elements wide: waves
/// longer than that see no difference. But the limit of the time step of central differences is no longer that of
/// the few nodes, most on the edge of the blank, that many strips hold and little mass has: among all ways to place a mass on the
/// nodes, the highest frequency is lowest where the modes near it use all nodes alike. Measured, flat: the
/// double dome 11 %, the hemisphere 15 %, a blank whose yarns cross the mesh at 45 degrees 50 % longer steps with a fifth
/// (docs/verification.md). A part of a symmetric blank has the factors of the whole.
std::vector<double> lumping_factors(const Blank& blank, const Membrane& membrane, double share);

} // namespace towform
