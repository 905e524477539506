#include "contact/contact.hpp"
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
  if (memory.reach >= 0.0 && norm_squared(p - memory.anchor) <= memory.reach * memory.reach)
    return surface.nearest_of(p, {memory.facets.data(), static_cast<std::size_t>(memory.count)});
  SurfacePoint nearest = surface.nearest(p, memory.hint);
  memory.hint = nearest.facet;
  memory.reach = -1.0;
  const double margin = half_thickness; // how far a node may slide before it is searched for again
  if (nearest.distance - half_thickness > 2.0 * margin) return nearest;
  // While the node moves by up to `margin`, its nearest facet stays within twice that of today's nearest
  // distance.
  thread_local std::vector<int> found;
  surface.tree().within(p, std::abs(nearest.distance) + 2.0 * margin + 1e-12, found);
  if (found.size() > SearchMemory::capacity) return nearest;
  std::copy(found.begin(), found.end(), memory.facets.begin());
  memory.count = static_cast<int>(found.size());
  memory.anchor = p;
  memory.reach = margin;
  return nearest;
}

/// Stick-slip return mapping: stretches the spring by the tangential movement and lets it slip back to the
/// cone. Returns the friction force on the node.
Vec3 friction_force(Vec3& stick, const Vec3& normal, const Vec3& movement, double stiffness, double limit,
                    double& dissipated)
{
  const Vec3 moved = stick + movement;
  const Vec3 trial = moved - dot(moved, normal) * normal;
  const double stretch = norm(trial);
  stick = trial;
  if (stiffness * stretch > limit) {
    stick *= limit / (stiffness * stretch);
    dissipated += limit * (stretch - limit / stiffness);
  }
  return -stiffness * stick;
}

} // namespace

void start(const Contact&, std::size_t nodes, ContactState& c)
{
  c.stick.assign(nodes, {});
  c.normal_force.assign(nodes, 0.0);
  c.memory.assign(nodes, {});
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

#pragma omp parallel for schedule(dynamic)
  for (int block = 0; block < blocks; ++block) {
    BlockSums& sum = sums[block];
    for (int n = block * block_size; n < std::min(nodes, (block + 1) * block_size); ++n) {
      SearchMemory& memory = c.memory[n];
      if (c.travel < memory.wake) continue;
      const SurfacePoint nearest = find_nearest(tool.surface, s.position[n] - shift, half, memory);
      const double gap = nearest.distance - half;
      // Behind the rim of an open surface there is no tool.
      if (gap >= 0.0 || (nearest.distance < 0.0 && nearest.on_border)) {
        memory.wake = c.travel + std::max(gap, 0.0);
        c.normal_force[n] = 0.0;
        c.stick[n] = {};
        continue;
      }
      const Vec3 relative = s.velocity[n] - velocity;
      const double stiffness = contact.stiffness[n], closing = -dot(relative, nearest.normal);
      const double elastic = -stiffness * gap;
      const double damped = std::max(elastic + contact.damping[n] * closing, 0.0); // never pulls
      const double tangential = contact.stick_ratio * stiffness;
      Vec3 force = damped * nearest.normal;
      if (tool.friction > 0.0)
        force += friction_force(c.stick[n], nearest.normal, dt * relative, tangential, tool.friction * damped,
                                sum.energies.friction);
      s.force[n] += force;
      c.normal_force[n] = damped;
      sum.reaction -= force;
      sum.energies.damping += (damped - elastic) * closing * dt;
      sum.energies.elastic += 0.5 * stiffness * gap * gap + 0.5 * tangential * norm_squared(c.stick[n]);
      if (-gap > sum.penetration) {
        sum.penetration = -gap;
        sum.deepest_node = n;
      }
    }
  }

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
