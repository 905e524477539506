#pragma once
#include "towform/vec3.hpp"
#include <array>

namespace towform {

/// The nodes of a block that touch a tool, side by side, so that one instruction serves several.
struct ContactBatch {
  static constexpr int size = 128;
  using Lanes = double[size]; // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise

  int count;
  std::array<int, size> node;
  alignas(64) Lanes nx, ny, nz, gap;          ///< tool's normal; negative gap [m]
  alignas(64) Lanes vx, vy, vz;               ///< velocity against the tool [m/s]
  alignas(64) Lanes stiffness, damping;       ///< k [N/m], c [N s/m]
  alignas(64) Lanes sx, sy, sz;               ///< stretch of the tangential spring [m]
  alignas(64) Lanes fx, fy, fz, normal_force; ///< on the node [N]
  alignas(64) Lanes elastic, damped, rubbed;  ///< stored; lost in the step by damping and friction [J]

  void add(int n, const Vec3& normal, double its_gap, const Vec3& velocity, double its_stiffness,
           double its_damping, const Vec3& stick)
  {
    const int i = count++;
    node[i] = n;
    nx[i] = normal.x;
    ny[i] = normal.y;
    nz[i] = normal.z;
    gap[i] = its_gap;
    vx[i] = velocity.x;
    vy[i] = velocity.y;
    vz[i] = velocity.z;
    stiffness[i] = its_stiffness;
    damping[i] = its_damping;
    sx[i] = stick.x;
    sy[i] = stick.y;
    sz[i] = stick.z;
  }
};

/// Normal force k g + damping, never pulling; Coulomb friction by stick-slip return mapping: a step's
/// tangential movement stretches the spring k_t = `stick_ratio` k and lets it slip back to the cone of
/// `friction`; the dashpot beside it acts while the node sticks.
void push(ContactBatch& b, double stick_ratio, double friction, double dt);

} // namespace towform
