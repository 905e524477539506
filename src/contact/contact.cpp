#include "contact/contact.hpp"
#include "contact/contact_batch.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>

namespace towform {

namespace {

/// Nodes are taken in blocks: a block belongs to one thread, and sums run over blocks in their order.
constexpr int block_size = ContactBatch::size;

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
    ContactBatch batch;
    batch.count = 0;
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
      batch.add(n, nearest.normal, gap, s.velocity[n] - velocity, contact.stiffness[n], contact.damping[n],
                c.stick[n]);
    }
    push(batch, contact.stick_ratio, tool.friction, dt);
    BlockSums& sum = sums[block];
    for (int i = 0; i < batch.count; ++i) {
      const int n = batch.node[i];
      const Vec3 force{batch.fx[i], batch.fy[i], batch.fz[i]};
      s.force[n] += force;
      c.normal_force[n] = batch.normal_force[i];
      c.stick[n] = {batch.sx[i], batch.sy[i], batch.sz[i]};
      sum.reaction -= force;
      sum.energies.damping += batch.damped[i];
      sum.energies.friction += batch.rubbed[i];
      sum.energies.elastic += batch.elastic[i];
      if (-batch.gap[i] > sum.penetration) {
        sum.penetration = -batch.gap[i];
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
