#pragma once
#include "element/stencil_runs.hpp"
#include "element/vec4.hpp"
#include "towform/state.hpp"
#include <array>
#include <cstdint>
#include <span>

namespace towform {

/// Some of a block's nodes side by side, so that one instruction serves several. Names as in Bending; a and b are the chords.
/// Arrays are longer than they need be: a power of two apart, loads would wait for stores.
struct BendingLanes {
  static constexpr int size = 128;
  using Lanes = double[size + 8]; // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise

  alignas(64) Lanes warp_x, warp_y, warp_z, weft_x, weft_y, weft_z; ///< second derivatives of x [1/m]
  alignas(64) Lanes ax, ay, az, bx, by, bz;                         ///< chords [m]
  alignas(64) Lanes nx, ny, nz, inverse;                            ///< normal, 1/|a x b|
  alignas(64) Lanes warp_now, weft_now;                             ///< curvatures [1/m]
  alignas(64) Lanes warp_moment, weft_moment;                       ///< times area [N m^2]
  alignas(64) Lanes on_ax, on_ay, on_az, on_bx, on_by, on_bz;       ///< forces on the chords' first ends [N]
  alignas(64) Lanes change_x, change_y, change_z;                   ///< what a run's weights share a multiple of [m]
  alignas(64) Lanes change_moment;                                  ///< and its moment [N]
  alignas(64) Lanes lost;                                           ///< in damping, of the time since the last look [J]
};

/// Vectors side by side.
struct Components {
  double *x, *y, *z;
  [[nodiscard]] Components from(int lane) const { return {x + lane, y + lane, z + lane}; }
};

/// A vector for each lane of a block.
struct VectorLanes {
  static constexpr int size = StencilLayout::most_lanes + StencilLayout::vector_size;
  using Lanes = double[size]; // NOLINT(modernize-avoid-c-arrays)
  alignas(64) Lanes x, y, z;

  [[nodiscard]] Components from(int lane) { return {x + lane, y + lane, z + lane}; }
  [[nodiscard]] Vec3 at(int lane) const { return {x[lane], y[lane], z[lane]}; }
  void set(int lane, const Vec3& v)
  {
    x[lane] = v.x;
    y[lane] = v.y;
    z[lane] = v.z;
  }
  void clear(int lanes);
};

/// What a run's nodes are made of (StencilRun), from one of them on.
struct Stencil {
  std::span<const StencilTerm> warp, weft, change;
  std::span<const StencilPoint> points;
  const YarnPair* times; ///< by what the change is multiplied, where there is one
};
/// Second derivatives of a field from the lane of the first node on; and adds the forces of moments.
void differentiate(const Stencil& s, const Components& field, int count, BendingLanes& lanes);
void spread_moments(const Stencil& s, BendingLanes& lanes, int count, const Components& force);
/// Chords, and adds the forces on them. `ends` as lanes ahead.
void draw_chords(const std::array<int, 4>& ends, const Components& position, int count, BendingLanes& lanes);
void spread_chords(const std::array<int, 4>& ends, const BendingLanes& lanes, int count, const Components& force);

/// What nodes are made of that have no run, by points of the block.
struct Patches {
  const int* first;           ///< of each node's terms, one more
  const std::uint16_t* point; ///< of each term of the whole sheet
  const int* weights_of;      ///< where each node's weights begin
  const YarnPair* weight;     ///< of all of them
};
void differentiate(const Patches& p, const Padded* field, int nodes, BendingLanes& lanes);
void draw_chords(const std::array<std::uint16_t, 4>* ends, const Padded* position, int nodes, BendingLanes& lanes);
void spread_moments(const Patches& p, const BendingLanes& lanes, int nodes, Padded* force);
void spread_chords(const std::array<std::uint16_t, 4>* ends, const BendingLanes& lanes, int nodes, Padded* force);

/// Normals from the chords.
void find_normals(int nodes, BendingLanes& lanes);
/// Curvatures: second derivatives along the normals.
void find_curvatures(int nodes, BendingLanes& lanes);
/// Forces on the chords: dkappa = n . d(x,ii) + x,ii . dn, of which only the part in the surface turns the normal.
void turn(int nodes, BendingLanes& lanes);

/// Moments of straight laws, M = stiffness (kappa + ahead change) + viscosity change, `change` being that since `curvature`, which
/// takes over what is new; `area` of each node [m^2].
struct StraightMoments {
  YarnPair stiffness, viscosity; ///< [N m]
  double ahead;
};
void bend(const StraightMoments& m, const double* area, YarnPair* curvature, int nodes, BendingLanes& lanes);
/// Those of curvatures alone.
void bend(const YarnPair& stiffness, const double* area, int nodes, BendingLanes& lanes);

} // namespace towform
