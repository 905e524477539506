#pragma once
#include "element/element_blocks.hpp"
#include "element/membrane_batches.hpp"
#include "element/yarn.hpp"
#include "element/yarn_strips.hpp"
#include "material/fabric_law.hpp"
#include "towform/blank.hpp"
#include "towform/state.hpp"
#include <array>
#include <span>
#include <vector>

namespace towform {

/// Throws std::invalid_argument when it has no area or is turned over.
FlatTriangle flat_triangle(const Blank& blank, const Triangle& t);

/// An element's yarns: F f0 = lambda f.
struct YarnVectors {
  Vec3 f1, f2;             ///< unit, current warp and weft
  double lambda1, lambda2; ///< stretches

  YarnVectors(const Triangle& t, const YarnGradients& g, std::span<const Vec3> position)
  {
    const Vec3 d1 = position[t[1]] - position[t[0]], d2 = position[t[2]] - position[t[0]];
    const Vec3 a1 = g.warp_1 * d1 + g.warp_2 * d2, a2 = g.weft_1 * d1 + g.weft_2 * d2;
    lambda1 = norm(a1);
    lambda2 = norm(a2);
    f1 = (1.0 / lambda1) * a1;
    f2 = (1.0 / lambda2) * a2;
  }
};

/// Membrane triangles of one ply, one integration point each, total Lagrangian: first Piola-Kirchhoff
/// resultant
///   P = T1 f1 x f01 + T2 f2 x f02 + N [(f2 - s f1) x f01/lambda1 + (f1 - s f2) x f02/lambda2]   [N/m]
/// (physics: from the surface to a stress). A constant-strain triangle locks where its edges cross stiff
/// yarns, so there yarns answer to the mean strain of their strip (element/yarn_strips.hpp), weighted by
/// area, and a soft spring K, `own_stiffness`, holds single triangles to their strip. The energy is
///   sum over strips A w(mean) + sum over entries A K (own - mean)^2 / 2,
/// so that forces are its exact derivative.
struct Membrane {
  std::span<const Triangle> triangles; ///< m, of the blank, which must outlive the membrane
  std::vector<double> node_area;   ///< n, a third of the elements round a node [m^2]
  YarnStrips strips;
  ElementBlocks blocks;
  MembraneBatches batches;
  double reference_sine = 0.0; ///< f01 . f02
  double thickness = 0.0;      ///< [m]
  YarnLaw yarn;
  double damping_time = 0.0;  ///< yarn damping: T += k damping_time d(strain)/dt [s]
  double own_stiffness = 0.0; ///< K [N/m]
  FabricLaw law;

  Membrane(const Blank& blank, const YarnLaw& yarn_law, FabricLaw fabric_law,
           YarnStrain yarn_strain = YarnStrain::automatic);

  /// Elastic energy of all yarns at the state's strains [J].
  [[nodiscard]] double yarn_energy(const State& s) const;
  [[nodiscard]] StripEntries entries(const ElementBlocks::Block& block) const;
  /// Reference areas of the elements, m [m^2].
  [[nodiscard]] std::vector<double> areas() const;
  /// work(element, flat triangle) for a block's own elements.
  template <class Work>
  void each_own(int block, const Work& work) const
  {
    const int first_element = blocks.blocks[block].first_element;
    for (const MembraneBatches::Batch& b : batches.own(block)) {
      const MembraneCoefficients c = batches.coefficients(b);
      for (int i = 0; i < b.count; ++i)
        work(static_cast<std::size_t>(first_element + b.first + i),
             FlatTriangle{{c.warp_1[i], c.warp_2[i], c.weft_1[i], c.weft_2[i]}, c.area[i]});
    }
  }
};

/// Sizes the membrane's arrays of a state whose positions are set, stress-free at the reference.
void start(const Membrane& membrane, State& s);

/// Forces of the blocks at x_n, those of nodes that one block alone reaches in s.force; advances the histories from x_(n-1) by dt and the works done in between.
void membrane_forces(const Membrane& membrane, State& s, double dt);

/// force[n] = sum over the node's blocks, of nodes that have several.
void assemble(const ElementBlocks& blocks, std::span<const Vec3> block_force, std::span<Vec3> force);

} // namespace towform
