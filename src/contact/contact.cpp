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

/// The nearest point as far as contact asks.
struct Nearest {
  Vec3 normal;
  double distance;
  bool on_border;
};

/// The tool's nearest point by the remembered facets while they are known to hold it, else by a search.
/// Remembers the plane that tells it from now on, if one does.
Nearest search(const ToolSurface& surface, const Vec3& p, double margin, SearchMemory& memory, NearPlane& plane)
{
  const auto known = [&memory] {
    return std::span<const NearFacet>(memory.facets.data(), static_cast<std::size_t>(memory.count));
  };
  double moved = norm(p - memory.anchor);
  SurfacePoint nearest;
  if (moved <= memory.reach) {
    nearest = surface.nearest_of(p, known(), moved);
  } else {
    double bound = 1e100;
    if (memory.count > 0)
      bound = std::sqrt(nearest_on_facet(surface.tree().facet(memory.facets.front().facet), p).distance_squared) *
                  (1.0 + 1e-12) +
              2.0 * margin;
    std::array<NearFacet, SearchMemory::capacity + 1> found;
    const std::size_t count = surface.tree().nearest_few(p, bound, found);
    memory.count = static_cast<int>(std::min(count, SearchMemory::capacity));
    std::copy_n(found.begin(), memory.count, memory.facets.begin());
    memory.anchor = p;
    moved = 0.0;
    nearest = surface.nearest_of(p, known(), moved);
    // While the node moves by r, its nearest facet is within r of today's nearest distance, and a facet left
    // out no nearer than its distance less r.
    const double left_out = count > SearchMemory::capacity ? found.back().distance : bound;
    memory.reach =
        static_cast<float>(std::min(0.5 * (left_out - std::abs(nearest.distance)), margin) * (1.0 - 1e-6));
  }
  plane.reach_squared = -1.0;
  if (nearest.inside) {
    const double reach =
        std::min(memory.reach - moved, surface.plane_reach(p, nearest, known(), moved));
    const Facet& facet = surface.tree().facet(nearest.facet);
    if (reach > 0.0) plane = {facet.normal, facet.offset, p, reach * reach};
  }
  return {nearest.normal, nearest.distance, nearest.on_border};
}

Nearest find_nearest(const ToolSurface& surface, const Vec3& p, double margin, SearchMemory& memory,
                     NearPlane& plane)
{
  if (norm_squared(p - plane.anchor) <= plane.reach_squared)
    return {plane.normal, dot(plane.normal, p) - plane.offset, false};
  return search(surface, p, margin, memory, plane);
}

} // namespace

void start(const Contact&, std::size_t nodes, ContactState& c)
{
  c.stick.assign(nodes, {});
  c.normal_force.assign(nodes, 0.0);
  c.plane.assign(nodes, {});
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
      const Nearest nearest =
          find_nearest(tool.surface, s.position[n] - shift, half, c.memory[n], c.plane[n]);
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
