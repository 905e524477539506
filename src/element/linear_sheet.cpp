#include "element/linear_sheet.hpp"
#include "element/membrane_work.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <memory>

namespace towform {

namespace {

void linear_block(const LinearSheet& sheet, std::span<const Vec3> motion, int number, Workplace& w, LinearForces& f)
{
  using Batch = MembraneBatches::Batch;
  const Membrane& membrane = sheet.membrane;
  const ElementBlocks::Block& block = membrane.blocks.blocks[number];
  const MembraneBatches& batches = membrane.batches;
  const std::uint16_t* corner = membrane.blocks.corners(block);
  const std::span<const int> nodes = membrane.blocks.slots.points(block.nodes);
  const double spring = membrane.own_stiffness;
  w.take(nodes, sheet.position);
  for (const Batch& b : batches.all(number)) {
    gather_edges(w.position.data(), corner + 3 * b.first, b.count, w.batch);
    yarn_vectors(batches.coefficients(b), w.batch, b.first, b.count, w.lanes);
  }
  w.take(nodes, motion);
  for (const Batch& b : batches.all(number)) {
    gather_edges(w.position.data(), corner + 3 * b.first, b.count, w.batch);
    motion_strains(batches.coefficients(b), w.batch, b.first, b.count, w.lanes);
  }
  const StripEntries entries = membrane.entries(block);
  sum_strips(entries, w.lanes, w.strips);
  const double stiffness = sheet.yarn_factor * membrane.yarn.stiffness - spring;
  for (int i = 0; i < block.strips; ++i)
    w.strips.base_tension[i] = stiffness * w.strips.sum[i] / membrane.strips.area[block.first_strip + i];
  hand_out(entries, w.strips, w.lanes);
  leave_out(membrane.blocks.entries_of_others(block), w.lanes);
  for (const Batch& b : batches.own(number)) {
    const MembraneCoefficients c = batches.coefficients(b);
    shear_angles(w.lanes, b.first, b.count, 0.0, w.batch);
    gather_edges(w.position.data(), corner + 3 * b.first, b.count, w.batch);
    motion_shear(c, sheet.shear_modulus, w.lanes, b.first, b.count, w.batch);
    shear_and_tension(c, spring, w.lanes, b.first, b.count, w.batch);
    add_forces(w.batch, corner + 3 * b.first, b.count, w.force.data());
  }
  for (const Batch& b : batches.guests(number)) {
    tension(batches.coefficients(b), spring, w.lanes, b.first, b.count, w.batch);
    add_forces(w.batch, corner + 3 * b.first, b.count, w.force.data());
  }
  w.give(membrane.blocks.slots, block.nodes, f.block_force, f.force);
}

} // namespace

void linear_forces(const LinearSheet& sheet, std::span<const Vec3> motion, LinearForces& f)
{
  const ElementBlocks& blocks = sheet.membrane.blocks;
  f.block_force.resize(std::max(f.block_force.size(), blocks.slots.count()));
  f.force.resize(motion.size());
  parallel_each(blocks.count(), [&](int number) {
    static thread_local const std::unique_ptr<Workplace> workplace = std::make_unique<Workplace>();
    linear_block(sheet, motion, number, *workplace, f);
  });
  assemble(blocks, f.block_force, f.force);
  for (const Bending& bending : sheet.bending)
    linear_bending_forces(bending, sheet.bending_factor, sheet.position, motion, f.block_force, f.force);
}

} // namespace towform
