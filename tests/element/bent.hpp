#pragma once
#include "element/bending.hpp"
#include "element/sheet.hpp"
#include <string>
#include <utility>
#include <vector>

namespace towform::test {

/// All ways in which a mesh can lie under the yarns: pattern, grid lines against the warp.
inline const std::vector<std::pair<Pattern, double>> meshes{{Pattern::diagonal, 0.0},  {Pattern::diagonal, 25.0},
                                                     {Pattern::diagonal, 45.0}, {Pattern::cross, 0.0},
                                                     {Pattern::cross, 25.0},    {Pattern::unstructured, 0.0}};

inline std::string named(Pattern pattern, double angle)
{
  return (pattern == Pattern::diagonal ? "diagonal"
          : pattern == Pattern::cross  ? "cross"
                                       : "unstructured") +
         std::string(" at ") + std::to_string(static_cast<int>(angle)) + " degrees";
}

inline std::vector<double> node_areas(const Blank& blank)
{
  std::vector<double> area(blank.mesh.points.size(), 0.0);
  for (const auto& [a, b, c] : blank.mesh.triangles) {
    const double twice =
        cross(blank.mesh.points[b] - blank.mesh.points[a], blank.mesh.points[c] - blank.mesh.points[a]).z;
    for (const int n : {a, b, c}) area[n] += twice / 6.0;
  }
  return area;
}

inline Bending bending_of(const Blank& blank, double warp, double weft,
                          const std::vector<SymmetryLine>& clamped = {})
{
  return {blank, clamped, node_areas(blank), MomentLaw(warp), MomentLaw(weft)};
}

/// work(node, place, patch) for every node.
template <class Work>
void each_node(const CurvatureOperator& op, const Work& work)
{
  for (const CurvatureOperator::Block& block : op.blocks)
    op.each_node(block, [&](int place, const CurvatureOperator::Patch& patch) { work(op.node[place], place, patch); });
}

/// Elastic forces and energy at given positions.
struct Bent {
  std::vector<Vec3> force;
  std::vector<YarnPair> curvature; ///< of each node
  double energy = 0.0;

  Bent(const Bending& bending, const std::vector<Vec3>& position)
  {
    State s;
    s.position = position;
    s.force.assign(position.size(), {});
    BendingState state;
    start(bending, position, state);
    bending_forces(bending, state, s, 1.0);
    force = s.force;
    curvature.resize(position.size());
    for (std::size_t place = 0; place < state.curvature.size(); ++place)
      if (const int n = bending.curvature.node[place]; n >= 0) curvature[n] = state.curvature[place];
    energy = bending_energy(bending, state);
  }
};

/// A point of the flat sheet rolled onto a cylinder of radius R whose axis is turned by `angle` from y.
inline Vec3 rolled(const Vec3& p, double radius, double angle)
{
  const Vec3 e{std::cos(angle), std::sin(angle), 0.0}, axis{-e.y, e.x, 0.0};
  const double turn = dot(p, e) / radius;
  return radius * std::sin(turn) * e + dot(p, axis) * axis + Vec3{0.0, 0.0, radius * (1.0 - std::cos(turn))};
}

inline std::vector<Vec3> rolled(const Blank& blank, double radius, double angle)
{
  std::vector<Vec3> x;
  for (const Vec3& p : blank.mesh.points) x.push_back(rolled(p, radius, angle));
  return x;
}

} // namespace towform::test
