#include "contact/contact.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {

/// Nodes are taken in blocks: a block belongs to one thread, and sums run over blocks in their order.
constexpr int block_size = 128;

struct BlockSums {
  Vec3 reaction;
  ContactEnergies energies;
  double penetration = 0.0;
  int deepest_node = 0;
};

/// Search: the tool's nearest point, from the remembered facets while they are known to hold it.
SurfacePoint find_nearest(const ToolSurface& surface, const Vec3& p, double half_thickness,
                          SearchMemory& memory)
{
  const auto remembered = [&](double moved) {
    return surface.nearest_of(p, {memory.facets.data(), static_cast<std::size_t>(memory.count)}, moved);
  };
  const double moved = norm(p - memory.anchor);
  if (moved <= memory.reach) return remembered(moved);
  const double margin = half_thickness; // how far a node may slide at most before it is searched for again
  double bound = 1e100;
  if (memory.count > 0)
    bound =
        std::sqrt(nearest_on_facet(surface.tree().facet(memory.facets.front().facet), p).distance_squared) *
            (1.0 + 1e-12) +
        2.0 * margin;
  std::array<NearFacet, SearchMemory::capacity + 1> found;
  const std::size_t count = surface.tree().nearest_few(p, bound, found);
  memory.count = static_cast<int>(std::min(count, SearchMemory::capacity));
  std::copy_n(found.begin(), memory.count, memory.facets.begin());
  memory.anchor = p;
  const SurfacePoint nearest = remembered(0.0);
  // While the node moves by r, its nearest facet is within r of today's nearest distance, and a facet left
  // out no nearer than its distance less r.
  const double left_out = count > SearchMemory::capacity ? found.back().distance : bound;
  memory.reach =
      static_cast<float>(std::min(0.5 * (left_out - std::abs(nearest.distance)), margin) * (1.0 - 1e-6));
  return nearest;
}

/// What a node's tangential contact is made of.
struct Friction {
  double stiffness; ///< of the stick spring [N/m]
  double damping;   ///< beside it [N s/m]
  double limit;     ///< mu times the normal force [N]
};

/// Stick-slip return mapping: stretches the spring by the tangential movement of a step, lets it slip back to
/// the cone. The dashpot acts while the node sticks. Returns the force on the node.
Vec3 friction_force(const Friction& f, const Vec3& normal, const Vec3& movement, double dt, Vec3& stick,
                    double& dissipated)
{
  const Vec3 tangential = movement - dot(movement, normal) * normal;
  const Vec3 trial = stick - dot(stick, normal) * normal + tangential;
  const double stretch = norm(trial);
  stick = trial;
  if (f.stiffness * stretch > f.limit) {
    stick *= f.limit / (f.stiffness * stretch);
    dissipated += f.limit * (stretch - f.limit / f.stiffness);
    return -f.stiffness * stick;
  }
  Vec3 force = -f.stiffness * stick - (f.damping / dt) * tangential;
  const double size = norm(force);
  if (size > f.limit) force *= f.limit / size;
  dissipated -= dot(force + f.stiffness * stick, tangential);
  return force;
}

} // namespace

void start(const Contact&, std::size_t nodes, ContactState& c)
{
  c.stick.assign(nodes, {});
  c.normal_force.assign(nodes, 0.0);
  c.memory.assign(nodes, {});
  c.wake.assign(nodes, 0.0);
}

void contact_forces(const Contact& contact, const Tool& tool, ToolState& tool_state, ContactState& c,
                    State& s, double dt, double fastest)
{
  const int nodes = static_cast<int>(s.position.size());
  const int blocks = (nodes + block_size - 1) / block_size;
  const Vec3 shift = tool_state.displacement * tool.direction,
             velocity = tool_state.velocity * tool.direction;
  const double half = contact.half_thickness;
  c.travel += (fastest + std::abs(tool_state.velocity)) * dt;
  std::vector<BlockSums> sums(static_cast<std::size_t>(blocks));

  parallel_each(blocks, [&](int block) {
    BlockSums& sum = sums[block];
    for (int n = block * block_size; n < std::min(nodes, (block + 1) * block_size); ++n) {
      if (c.travel < c.wake[n]) continue;
      const SurfacePoint nearest = find_nearest(tool.surface, s.position[n] - shift, half, c.memory[n]);
      const double gap = nearest.distance - half;
      // Behind the rim of an open surface there is no tool.
      if (gap >= 0.0 || (nearest.distance < 0.0 && nearest.on_border)) {
        c.wake[n] = c.travel + std::max(gap, 0.0);
        c.normal_force[n] = 0.0;
        c.stick[n] = {};
        continue;
      }
      const Vec3 relative = s.velocity[n] - velocity;
      const double stiffness = contact.stiffness[n], closing = -dot(relative, nearest.normal);
      const double elastic = -stiffness * gap;
      const double damped = std::max(elastic + contact.damping[n] * closing, 0.0); // never pulls
      const Friction friction{contact.stick_ratio * stiffness, contact.damping[n], tool.friction * damped};
      Vec3 force = damped * nearest.normal;
      if (tool.friction > 0.0)
        force +=
            friction_force(friction, nearest.normal, dt * relative, dt, c.stick[n], sum.energies.friction);
      s.force[n] += force;
      c.normal_force[n] = damped;
      sum.reaction -= force;
      sum.energies.damping += (damped - elastic) * closing * dt;
      sum.energies.elastic +=
          0.5 * stiffness * gap * gap + 0.5 * friction.stiffness * norm_squared(c.stick[n]);
      if (-gap > sum.penetration) {
        sum.penetration = -gap;
        sum.deepest_node = n;
      }
    }
  });

  tool_state.reaction = {};
  c.energies.elastic = 0.0;
  c.penetration = 0.0;
  for (const BlockSums& sum : sums) {
    tool_state.reaction += sum.reaction;
    c.energies.elastic += sum.energies.elastic;
    c.energies.damping += sum.energies.damping;
    c.energies.friction += sum.energies.friction;
    if (sum.penetration > c.penetration) {
      c.penetration = sum.penetration;
      c.deepest_node = sum.deepest_node;
    }
  }
}

} // namespace towform
