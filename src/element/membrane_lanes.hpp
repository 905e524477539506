#pragma once
#include "element/element_blocks.hpp"
#include "element/vec4.hpp"
#include "element/yarn.hpp"
#include "material/fabric_law.hpp"

namespace towform {

/// Elements of a block side by side, so that one instruction serves several: each array has a place per element.
/// Names as in Membrane; 1 and 2 are warp and weft.
struct BlockLanes {
  static constexpr int size = ElementBlocks::stride;
  using Lanes = double[size];         // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise
  using Families = double[2 * size];  // NOLINT(modernize-avoid-c-arrays): warps, then wefts
  alignas(64) Lanes f1x, f1y, f1z, f2x, f2y, f2z; ///< unit yarn vectors
  alignas(64) Families over_stretch;              ///< 1/lambda
  alignas(64) Families weighed_strain;            ///< (lambda - 1) times the reference area [m^2]
  alignas(64) Families base_tension;              ///< tension less that of the element's own spring [N/m]
};

/// Strips of a block side by side.
struct StripLanes {
  static constexpr int size = 2 * ElementBlocks::capacity;
  using Lanes = double[size];      // NOLINT(modernize-avoid-c-arrays)
  alignas(64) Lanes sum;          ///< of the entries' weighed strains [m^2]
  alignas(64) Lanes base_tension; ///< [N/m]
  alignas(64) Lanes lost;         ///< in damping, of the step [J]
};

/// Some elements of a block through one part of the work.
struct MembraneBatch {
  static constexpr int size = 64;
  using Lanes = double[size]; // NOLINT(modernize-avoid-c-arrays)

  alignas(64) Lanes d1x, d1y, d1z, d2x, d2y, d2z; ///< edges from corner 0 [m]
  alignas(64) Lanes sine;                         ///< f1 . f2
  alignas(64) Lanes angle, force, rate;           ///< of the law's point
  alignas(64) Lanes lost;                         ///< power dissipated over cos(theta)
  alignas(64) Lanes work, dissipated;             ///< of the step [J]
  alignas(64) Lanes p1x, p1y, p1z, p2x, p2y, p2z; ///< forces on corners 1 and 2 [N]
};

/// The batch's elements in the state, as the step before left them. Names as in State.
struct ShearLanes {
  double *sine, *angle, *force, *rate;
};

/// What the elements of a batch are made of: gradients [1/m] and reference areas [m^2].
struct MembraneCoefficients {
  const double *warp_1, *warp_2, *weft_1, *weft_2, *area;
};

/// Yarn vectors and strains of places first, first + 1, ... of the block from the batch's edges.
void yarn_vectors(const MembraneCoefficients& c, const MembraneBatch& b, int first, int count, BlockLanes& lanes);

/// Sine and shear angle, counted from `reference_angle` [rad].
void shear_angles(const BlockLanes& lanes, int first, int count, double reference_angle, MembraneBatch& b);

/// Forces and rates of a law's points at the batch's angles, dt after the old ones: the same bits as the law's own update.
void update(const ViscousLaw& law, const ShearLanes& old, MembraneBatch& b, int count, double dt);
void update(const ElasticLaw& law, const ShearLanes& old, MembraneBatch& b, int count, double dt);

/// Works of the step; the state takes over what is new.
void keep(const double* area, double dt, int count, MembraneBatch& b, const ShearLanes& state);

/// Sum in an order that vectors share: eight sums side by side, then these.
double sum(const double* values, int count);

/// Corner forces of tension and shear; `spring` is that of elements to their strips [N/m].
void shear_and_tension(const MembraneCoefficients& c, double spring, const BlockLanes& lanes, int first, int count,
                       MembraneBatch& b);

/// The same of small motions, whose edges are in the batch: strains along yarns that stay as they are, and shear force at
/// `modulus` dN/dtheta [N/m].
void motion_strains(const MembraneCoefficients& c, const MembraneBatch& b, int first, int count, BlockLanes& lanes);
void motion_shear(const MembraneCoefficients& c, double modulus, const BlockLanes& lanes, int first, int count,
                  MembraneBatch& b);

/// Corner forces of tension alone.
void tension(const MembraneCoefficients& c, double spring, const BlockLanes& lanes, int first, int count,
             MembraneBatch& b);

/// The strips of a block by their entries.
struct StripEntries {
  const int* first; ///< one more than strips
  const ElementBlocks::Entry* entry;
  int count;
};
/// Sums the weighed strains of every strip's entries, and hands the strips' base tensions to their entries.
void sum_strips(const StripEntries& s, const BlockLanes& lanes, StripLanes& strips);
void hand_out(const StripEntries& s, const StripLanes& strips, BlockLanes& lanes);
/// No tension, nor spring, where the strip is another block's.
void leave_out(std::span<const ElementBlocks::Entry> entries, BlockLanes& lanes);

/// Base tensions of strips from the sums over their entries, `viscosity` [N/m] times the change of strain being the
/// tension of damping; advances `strain`. `area` of each strip [m^2].
void strip_tensions(const YarnLaw& yarn, double viscosity, double spring, const double* area, double* strain, int count,
                    StripLanes& s);

/// Edges of elements from the nodes' positions; `corner` three an element.
void gather_edges(const Padded* position, const std::uint16_t* corner, int count, MembraneBatch& b);

/// Adds the corner forces of elements to those of the nodes.
void add_forces(const MembraneBatch& b, const std::uint16_t* corner, int count, Padded* force);

} // namespace towform
