#pragma once
#include "solver/statics.hpp"
#include "towform/case.hpp"

namespace towform {

/// A case for the implicit solver: what does not change while it runs.
struct StaticsCase {
  QuadrilateralGrid grid;
  FabricMaterial material;
  StaticsModel model;
};

/// Holds of a rectangle's grid: nodes, ties and groups of every boundary. A grip holds its edge. A picture
/// frame, as in the paper: corner (-a/2, -b/2) held, the opposite one driven along the diagonal, the other
/// two free, held by the yarns between them, and every edge node at its share of the straight line between
/// its corners. (The arms are thus as stiff as the yarns; rigid ones would give Eq. 13 whatever the
/// material.)
struct Holds {
  std::vector<HeldNode> held;
  std::vector<TiedNode> ties;
  std::vector<HeldGroup> groups;
};
Holds holds_of(const std::vector<BoundaryParameters>& boundaries, const QuadrilateralGrid& grid);

/// Meshes the blank and tabulates the material. Throws InputError with every issue found: tools, triangles,
/// nothing that moves, motions out of the plane, constituents out of range.
StaticsCase build_statics(const Case& c);

} // namespace towform
