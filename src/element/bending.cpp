#include "element/bending.hpp"
#include "element/bending_lanes.hpp"
#include "element/held_bending.hpp"
#include "element/membrane_lanes.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace towform {

namespace {

/// Enough for uniform bending to be exact to some 1e-4; see moment_balance.hpp.
constexpr int balance_rounds = 50;

} // namespace

Bending::Bending(const Blank& blank, std::span<const SymmetryLine> clamped, std::span<const double> node_area,
                 MomentLaw of_warp, MomentLaw of_weft)
    : curvature(blank, clamped, balance_rounds), warp(std::move(of_warp)), weft(std::move(of_weft))
{
  if (!curvature.complete())
    throw std::invalid_argument("the blank has too few elements to tell its curvature; bending needs more");
  area.reserve(curvature.node.size());
  for (const int n : curvature.node) area.push_back(n < 0 ? 0.0 : node_area[n]);
}

std::vector<double> Bending::frequency_bound(std::span<const double> mass) const
{
  const std::array<double, 2> stiffness{warp.stiffness(), weft.stiffness()};
  std::vector<double> bound(mass.size(), 0.0);
  for (const CurvatureOperator::Block& block : curvature.blocks)
    curvature.each_node(block, [&](int place, const CurvatureOperator::Patch& patch) {
      std::array<double, 2> sum{};
      patch.each_term([&](int, const YarnPair& weight) {
        sum[0] += std::abs(weight.warp);
        sum[1] += std::abs(weight.weft);
      });
      patch.each_term([&](int of_sheet, const YarnPair& weight) {
        const auto point = static_cast<std::size_t>(of_sheet);
        const std::size_t node = point < mass.size()
                                     ? point
                                     : static_cast<std::size_t>(curvature.images[point - mass.size()].source);
        bound[node] +=
            area[place] *
            (stiffness[0] * sum[0] * std::abs(weight.warp) + stiffness[1] * sum[1] * std::abs(weight.weft)) /
            mass[node];
      });
    });
  return bound;
}

void start(const Bending& bending, std::span<const Vec3> position, BendingState& b)
{
  const CurvatureOperator& op = bending.curvature;
  const std::vector<YarnPair> of_node = op.at(position);
  b.curvature.assign(op.node.size(), {});
  for (std::size_t place = 0; place < op.node.size(); ++place)
    if (op.node[place] >= 0) b.curvature[place] = of_node[op.node[place]];
  b.held.assign(bending.interval > 1 ? position.size() : 0, {});
  b.damping.assign(op.blocks.size(), 0.0);
  b.image.assign(op.images.size(), {});
}

namespace {

/// A vector for each point of a block: by lanes where it has runs, else by slots; those that single nodes share with runs by their
/// place among them.
struct PointVectors {
  VectorLanes lanes;
  std::vector<Padded> singles;

  void take(const CurvatureOperator& op, const CurvatureOperator::Block& block, const ImagedPositions& x)
  {
    const std::span<const int> points = op.slots.points(block.points);
    if (block.runs == 0) {
      singles.resize(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) singles[i].set(x[points[i]]);
      return;
    }
    lanes.clear(block.lanes);
    const std::uint16_t* lane = op.lane.data() + block.points.first;
    for (std::size_t i = 0; i < points.size(); ++i) lanes.set(lane[i], x[points[i]]);
    singles.resize(static_cast<std::size_t>(block.shared));
    for (int i = 0; i < block.shared; ++i) singles[i].set(lanes.at(op.shared_lane[block.first_shared + i]));
  }
  void clear(const CurvatureOperator::Block& block)
  {
    if (block.runs > 0) lanes.clear(block.lanes);
    singles.assign(static_cast<std::size_t>(block.runs > 0 ? block.shared : block.points.count), {});
  }
  /// Brings what single nodes have gathered to the lanes.
  void join(const CurvatureOperator& op, const CurvatureOperator::Block& block)
  {
    for (int i = 0; i < block.shared; ++i) {
      const int lane = op.shared_lane[block.first_shared + i];
      lanes.set(lane, lanes.at(lane) + singles[i].vec3());
    }
  }
};

/// What a thread needs to compute a block.
struct BendingWork {
  PointVectors position, motion, force;
  BendingLanes lanes;

  static BendingWork& here()
  {
    static thread_local const std::unique_ptr<BendingWork> work = std::make_unique<BendingWork>();
    return *work;
  }
  /// work(terms, chords' ends, of, first place, nodes) on parts of a block that the lanes hold; `of` finds what the terms are counted in.
  template <class Work>
  static void each_part(const CurvatureOperator& op, const CurvatureOperator::Block& block, const Work& work)
  {
    constexpr int most = BendingLanes::size;
    for (int r = block.first_run; r < block.first_run + block.runs; ++r) {
      const CurvatureOperator::Run& run = op.runs[r];
      const StencilTerm* const term = op.term.data() + run.first_term;
      const auto part = [&](int from, int count) { return std::span(term + from, static_cast<std::size_t>(count)); };
      const Stencil stencil{part(0, run.warp_terms), part(run.warp_terms, run.weft_terms),
                            part(run.warp_terms + run.weft_terms, run.change_terms),
                            {op.run_point.data() + run.first_point, static_cast<std::size_t>(run.points)},
                            op.times.data() + run.first_time};
      for (int i = 0; i < run.count; i += most) {
        Stencil from_here = stencil;
        from_here.times += i;
        work(from_here, run.ends, [lane = run.first_lane + i](PointVectors& v) { return v.lanes.from(lane); }, run.first_place + i,
             std::min(most, run.count - i));
      }
    }
    const int first_place = block.first_place + block.places - block.singles;
    for (int i = 0; i < block.singles; i += most) {
      const int n = block.first_single + i;
      work(Patches{op.first.data() + n, op.point.data(), op.weights_of.data() + n, op.weight.data()}, op.ends.data() + n,
           [](PointVectors& v) { return v.singles.data(); }, first_place + i, std::min(most, block.singles - i));
    }
  }
  /// Hands the block's forces on.
  void give(const CurvatureOperator& op, const CurvatureOperator::Block& block, std::span<Vec3> block_force, std::span<Vec3> of_all)
  {
    force.join(op, block);
    const bool in_lanes = block.runs > 0;
    const std::uint16_t* lane = op.lane.data() + block.points.first;
    const BlockSlots::Targets targets = op.slots.targets(block.points, of_all, block_force);
    for (int i = 0; i < block.points.count; ++i) {
      const Vec3 sum = in_lanes ? force.lanes.at(lane[i]) : force.singles[i].vec3();
      Vec3& to = targets[i];
      to = op.slots.reaches_alone(block.points, i) ? to + sum : sum;
    }
  }
};

/// Moments of the curvatures, now or in the middle of the time for which they are held. dt from one look at the curvatures to the next.
void find_moments(const Bending& bending, double dt, const double* area, YarnPair* curvature, int nodes, BendingLanes& l)
{
  const double ahead = held_ahead(bending.interval);
  const YarnPair stiffness{bending.warp.stiffness(), bending.weft.stiffness()};
  const YarnPair viscosity{stiffness.warp * bending.damping_time / dt, stiffness.weft * bending.damping_time / dt};
  if (bending.warp.is_straight() && bending.weft.is_straight()) {
    bend({stiffness, viscosity, ahead}, area, curvature, nodes, l);
    return;
  }
  for (int n = 0; n < nodes; ++n) {
    const YarnPair now{l.warp_now[n], l.weft_now[n]};
    const YarnPair change{now.warp - curvature[n].warp, now.weft - curvature[n].weft};
    l.warp_moment[n] = area[n] * (bending.warp.moment(now.warp + ahead * change.warp) + viscosity.warp * change.warp);
    l.weft_moment[n] = area[n] * (bending.weft.moment(now.weft + ahead * change.weft) + viscosity.weft * change.weft);
    l.lost[n] = area[n] * (viscosity.warp * change.warp * change.warp + viscosity.weft * change.weft * change.weft);
    curvature[n] = now;
  }
}

void bend_block(const Bending& bending, int number, double dt, BendingState& b, State& s, std::span<Vec3> force)
{
  const CurvatureOperator& op = bending.curvature;
  const CurvatureOperator::Block& block = op.blocks[number];
  BendingWork& w = BendingWork::here();
  w.position.take(op, block, {s.position, b.image});
  w.force.clear(block);
  BendingWork::each_part(op, block, [&](const auto& terms, const auto& ends, const auto& of, int place, int nodes) {
    BendingLanes& l = w.lanes;
    differentiate(terms, of(w.position), nodes, l);
    draw_chords(ends, of(w.position), nodes, l);
    find_normals(nodes, l);
    find_curvatures(nodes, l);
    find_moments(bending, dt, bending.area.data() + place, b.curvature.data() + place, nodes, l);
    b.damping[number] += sum(l.lost, nodes);
    turn(nodes, l);
    spread_moments(terms, l, nodes, of(w.force));
    spread_chords(ends, l, nodes, of(w.force));
  });
  w.give(op, block, s.block_force, force);
}

void place_images(const Bending& bending, std::span<const Vec3> position, std::vector<Vec3>& image)
{
  const std::vector<MirrorImage>& images = bending.curvature.images;
  image.resize(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) image[i] = images[i].position(position);
}

void assemble(const Bending& bending, std::span<const Vec3> block_force, std::span<Vec3> force)
{
  const BlockSlots& slots = bending.curvature.slots;
  const std::vector<MirrorImage>& images = bending.curvature.images;
  const std::span<const int> points = slots.summed();
  const auto is_node = [&](int point) { return point < static_cast<int>(force.size()); };
  const auto nodes = std::partition_point(points.begin(), points.end(), is_node) - points.begin();
  parallel_ranges(nodes, [&](auto begin, auto end) {
    for (auto i = begin; i < end; ++i) force[points[i]] += slots.sum(block_force, i);
  });
  for (auto i = nodes; i < static_cast<std::ptrdiff_t>(points.size()); ++i)
    images[static_cast<std::size_t>(points[i]) - force.size()].hand_on(slots.sum(block_force, i), force);
}

} // namespace

void bending_forces(const Bending& bending, BendingState& b, State& s, double dt)
{
  const bool holds = bending.interval > 1;
  const auto nodes = static_cast<std::ptrdiff_t>(s.force.size());
  if (s.step % bending.interval == 0) {
    place_images(bending, s.position, b.image);
    s.block_force.resize(std::max(s.block_force.size(), bending.curvature.slots.count())); // the membrane's have been summed
    if (holds)
      parallel_ranges(nodes, [&](auto begin, auto end) { std::fill(b.held.begin() + begin, b.held.begin() + end, Vec3{}); });
    std::vector<Vec3>& force = holds ? b.held : s.force;
    parallel_each(static_cast<int>(bending.curvature.blocks.size()),
                  [&](int number) { bend_block(bending, number, bending.interval * dt, b, s, force); });
    assemble(bending, s.block_force, force);
  }
  if (!holds) return;
  parallel_ranges(nodes, [&](auto begin, auto end) {
    for (auto n = begin; n < end; ++n) s.force[n] += b.held[n];
  });
}

void linear_bending_forces(const Bending& bending, double factor, std::span<const Vec3> position,
                           std::span<const Vec3> motion, std::vector<Vec3>& block_force, std::span<Vec3> force)
{
  std::vector<Vec3> image, image_motion;
  place_images(bending, position, image);
  place_images(bending, motion, image_motion);
  block_force.resize(std::max(block_force.size(), bending.curvature.slots.count()));
  const YarnPair stiffness{factor * bending.warp.stiffness(), factor * bending.weft.stiffness()};
  const CurvatureOperator& op = bending.curvature;
  parallel_each(static_cast<int>(op.blocks.size()), [&](int number) {
    const CurvatureOperator::Block& block = op.blocks[number];
    BendingWork& w = BendingWork::here();
    w.position.take(op, block, {position, image});
    w.motion.take(op, block, {motion, image_motion});
    w.force.clear(block);
    BendingWork::each_part(op, block, [&](const auto& terms, const auto& ends, const auto& of, int place, int nodes) {
      BendingLanes& l = w.lanes;
      draw_chords(ends, of(w.position), nodes, l);
      find_normals(nodes, l);
      differentiate(terms, of(w.motion), nodes, l);
      find_curvatures(nodes, l);
      bend(stiffness, bending.area.data() + place, nodes, l);
      spread_moments(terms, l, nodes, of(w.force));
    });
    w.give(op, block, block_force, force);
  });
  assemble(bending, block_force, force);
}

double bending_energy(const Bending& bending, const BendingState& b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < b.curvature.size(); ++n)
    sum += bending.area[n] *
           (bending.warp.energy(b.curvature[n].warp) + bending.weft.energy(b.curvature[n].weft));
  return sum;
}

} // namespace towform
