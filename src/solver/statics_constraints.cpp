#include "solver/statics_constraints.hpp"
#include <cassert>

namespace towform {

namespace {

struct Place {
  bool is_held;
  int index; ///< among the free or the held nodes
};

Eigen::VectorXd gathered(std::span<const Vec3> position, std::size_t count, auto node_of)
{
  Eigen::VectorXd v(2 * static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& x = position[node_of(i)];
    v[2 * i] = x.x;
    v[2 * i + 1] = x.y;
  }
  return v;
}

} // namespace

LinearConstraints::LinearConstraints(std::size_t nodes, std::vector<HeldNode> held_list,
                                     std::span<const TiedNode> ties)
    : held_nodes(std::move(held_list))
{
  constexpr int unknown = -1, tied = -2;
  std::vector<Place> place(nodes, {false, unknown});
  for (std::size_t i = 0; i < held_nodes.size(); ++i) place[held_nodes[i].node] = {true, static_cast<int>(i)};
  for (const TiedNode& t : ties) place[t.node] = {false, tied};
  for (std::size_t n = 0; n < nodes; ++n)
    if (place[n].index == unknown) {
      place[n].index = static_cast<int>(free_nodes.size());
      free_nodes.push_back(static_cast<int>(n));
    }

  std::vector<Eigen::Triplet<double>> free_entries, held_entries;
  const auto add = [&](int node, int master, double weight) {
    const Place& m = place[master];
    assert(m.index >= 0);
    for (int c = 0; c < 2; ++c)
      (m.is_held ? held_entries : free_entries).emplace_back(2 * node + c, 2 * m.index + c, weight);
  };
  for (std::size_t n = 0; n < nodes; ++n)
    if (place[n].index != tied) add(static_cast<int>(n), static_cast<int>(n), 1.0);
  for (const TiedNode& t : ties) {
    add(t.node, t.from, 1.0 - t.t);
    add(t.node, t.to, t.t);
  }
  const auto size = [](std::size_t count) { return 2 * static_cast<Eigen::Index>(count); };
  free.resize(size(nodes), size(free_nodes.size()));
  free.setFromTriplets(free_entries.begin(), free_entries.end());
  held.resize(size(nodes), size(held_nodes.size()));
  held.setFromTriplets(held_entries.begin(), held_entries.end());
}

Eigen::VectorXd LinearConstraints::plane_of(std::span<const Vec3> position)
{
  return gathered(position, position.size(), [](std::size_t i) { return i; });
}

Eigen::VectorXd LinearConstraints::free_part(std::span<const Vec3> position) const
{
  return gathered(position, free_nodes.size(), [&](std::size_t i) { return free_nodes[i]; });
}

Eigen::VectorXd LinearConstraints::held_part(std::span<const Vec3> position) const
{
  return gathered(position, held_nodes.size(), [&](std::size_t i) { return held_nodes[i].node; });
}

void LinearConstraints::place(const Eigen::VectorXd& q, const Eigen::VectorXd& p,
                              std::span<Vec3> position) const
{
  const Eigen::VectorXd x = free * q + held * p;
  for (std::size_t n = 0; n < position.size(); ++n) {
    position[n].x = x[2 * static_cast<Eigen::Index>(n)];
    position[n].y = x[2 * static_cast<Eigen::Index>(n) + 1];
  }
}

} // namespace towform
