#pragma once
#include "element/curvature_patch.hpp"
#include "towform/vec3.hpp"
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace towform {

/// What a point so many lanes ahead of a node gives to a sum there.
struct StencilTerm {
  int ahead;
  double weight;
};
/// What it gives to all that is summed at a node.
struct StencilPoint {
  int ahead;
  double warp, weft; ///< second derivatives [1/m^2]
  double change;     ///< [-]
};

/// Nodes of a block that stand in the rows of a lattice and whose patches are alike. The block's points lie in lanes, row after
/// row, so that what one node takes from a lane the next one takes from the lane after: vectors load them without being told
/// where. Lanes in between that are not such nodes are computed too and count for nothing. Weights on a ring of six neighbours
/// are exact for quadratics in one way but for a multiple of one vector, `change`: whatever the balance of moments has made of
/// them, nodes differ in that multiple alone.
struct StencilRun {
  int first_lane = 0;
  std::vector<int> nodes;           ///< of every lane, whole vectors of them: which of the block's nodes, or -1
  std::array<int, 4> ends{};        ///< of the chords, as lanes ahead
  std::vector<StencilPoint> points; ///< ascending; what is nothing but rounding is 0
  std::vector<YarnPair> times;      ///< of every lane, by what `change` is multiplied [1/m^2]; none where all are alike
};

/// Where the points of a block are, and the runs of its nodes.
struct StencilLayout {
  static constexpr int most_lanes = 1024;
  static constexpr int vector_size = 8; ///< lanes beyond the last that vectors may touch

  int lanes = 0;                    ///< 0: no runs, and no lanes
  std::vector<std::uint16_t> lane;  ///< of each point; beyond those of the lattice where that has no place for it
  std::vector<StencilRun> runs;
};

/// The runs among nodes first_node, first_node + 1, ... with these patches. `points` that they reach, ascending; `flat` places of all.
StencilLayout find_runs(std::span<const CurvaturePatch> patches, int first_node, std::span<const int> points,
                        std::span<const Vec3> flat);

} // namespace towform
