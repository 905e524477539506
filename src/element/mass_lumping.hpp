#pragma once
#include "element/membrane.hpp"
#include "towform/blank.hpp"
#include <vector>

namespace towform {

/// Factors on the thirds of its triangles' masses that a node has: a `share` of the sheet's mass goes to the nodes in proportion to
/// how stiff the strips of yarn hold each (the trace of its block of K) and how heavy the elements round it are, the rest stays
/// where it is. The sheet weighs what it did, and so, to some hundredths, does every part of it some elements wide: waves longer than
/// that see no difference. But the step of central differences is no longer limited by the few nodes, most on the edge of the blank,
/// that many strips hold and little mass has: of all ways to place a mass on the nodes, the highest frequency is lowest where the
/// modes near it use all nodes alike. Steps with a fifth over those with thirds alone: double dome 1.11, with its yarns at 45 degrees
/// to the mesh 1.49, hemisphere 1.14 (told by `towform run` as it begins), and the limit stays where it is while they are pressed.
/// But a sheet that crumples over few elements becomes stiff where it was not, at nodes inside its strips, and its limit falls: the
/// corners of a sheet that hangs freely over a male double dome have lost a third of the limit with lumping when without it nothing
/// is seen yet. A part of a symmetric blank has the factors of the whole.
std::vector<double> lumping_factors(const Blank& blank, const Membrane& membrane, double share);

} // namespace towform
