#pragma once
#include "towform/vec3.hpp"
#include <Eigen/SparseCore>
#include <span>
#include <vector>

namespace towform {

/// A node whose place is prescribed: its reference place + displacement(group) * direction.
struct HeldNode {
  int node;
  int group; ///< of nodes that move together
};

/// A node on the straight line between two others: x = (1 - t) x_from + t x_to.
struct TiedNode {
  int node;
  int from, to;
  double t;
};

/// Linear constraints of the planar problem, by elimination: x = free q + held p (z does not move). The
/// tangent of the rest, free^T K free, stays exact. Masters of a tie are free or held, not tied themselves
/// (asserted).
struct LinearConstraints {
  using Sparse = Eigen::SparseMatrix<double>;
  Sparse free; ///< 2n x free unknowns
  Sparse held; ///< 2n x 2 held nodes, in their order
  std::vector<int> free_nodes;
  std::vector<HeldNode> held_nodes;

  LinearConstraints(std::size_t nodes, std::vector<HeldNode> held_list, std::span<const TiedNode> ties);

  /// x, y of every node.
  static Eigen::VectorXd plane_of(std::span<const Vec3> position);
  /// Of the free nodes and of the held ones.
  [[nodiscard]] Eigen::VectorXd free_part(std::span<const Vec3> position) const;
  [[nodiscard]] Eigen::VectorXd held_part(std::span<const Vec3> position) const;
  /// Sets x and y of every node from the unknowns.
  void place(const Eigen::VectorXd& q, const Eigen::VectorXd& p, std::span<Vec3> position) const;
};

} // namespace towform
