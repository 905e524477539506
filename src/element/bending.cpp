#include "element/bending.hpp"
#include "element/held_bending.hpp"
#include "element/vec4.hpp"
#include "parallel/parallel.hpp"
#include "parallel/vector_clones.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace towform {

namespace {

/// Enough for uniform bending to be exact to some 1e-4; see moment_balance.hpp.
constexpr int balance_rounds = 50;

} // namespace

Bending::Bending(const Blank& blank, std::span<const SymmetryLine> clamped, std::vector<double> node_area,
                 MomentLaw of_warp, MomentLaw of_weft)
    : curvature(blank, clamped, balance_rounds), area(std::move(node_area)), warp(std::move(of_warp)),
      weft(std::move(of_weft))
{
  if (!curvature.complete())
    throw std::invalid_argument("the blank has too few elements to tell its curvature; bending needs more");
}

std::vector<double> Bending::frequency_bound(std::span<const double> mass) const
{
  const std::array<double, 2> stiffness{warp.stiffness(), weft.stiffness()};
  std::vector<double> bound(mass.size(), 0.0);
  for (std::size_t n = 0; n < curvature.nodes(); ++n) {
    std::array<double, 2> sum{};
    curvature.each_term(n, [&](int, const YarnPair& weight) {
      sum[0] += std::abs(weight.warp);
      sum[1] += std::abs(weight.weft);
    });
    curvature.each_term(n, [&](int of_sheet, const YarnPair& weight) {
      const auto point = static_cast<std::size_t>(of_sheet);
      const std::size_t node = point < mass.size()
                                   ? point
                                   : static_cast<std::size_t>(curvature.images[point - mass.size()].source);
      bound[node] +=
          area[n] *
          (stiffness[0] * sum[0] * std::abs(weight.warp) + stiffness[1] * sum[1] * std::abs(weight.weft)) /
          mass[node];
    });
  }
  return bound;
}

void start(const Bending& bending, std::span<const Vec3> position, BendingState& b)
{
  b.curvature = bending.curvature.at(position);
  b.held.assign(bending.interval > 1 ? position.size() : 0, {});
  b.damping.assign(bending.curvature.blocks.size(), 0.0);
  b.image.assign(bending.curvature.images.size(), {});
}

namespace {

/// A block's nodes side by side.
struct BendingLanes {
  static constexpr int size = CurvatureOperator::block_size;
  using Lanes = double[size]; // NOLINT(modernize-avoid-c-arrays): plain loops over them vectorise

  alignas(64) Lanes warp_x, warp_y, warp_z, weft_x, weft_y, weft_z; ///< second derivatives of x [1/m]
  alignas(64) Lanes ax, ay, az, bx, by, bz;                         ///< chords [m]
  alignas(64) Lanes nx, ny, nz, inverse;                            ///< normal, 1/|a x b|
  alignas(64) Lanes warp_now, weft_now;                             ///< curvatures [1/m]
  alignas(64) Lanes warp_moment, weft_moment;                       ///< times area [N m^2]
  alignas(64) Lanes on_ax, on_ay, on_az, on_bx, on_by, on_bz;       ///< forces on the chords' first ends [N]
};

/// What the nodes of a block are made of.
struct Patches {
  const int* first;                         ///< of each node's terms, one more
  const std::uint16_t* point;               ///< of each term of the whole sheet
  const int* weights_of;                    ///< where each node's weights begin
  const YarnPair* weight;                   ///< of all of them
  const std::array<std::uint16_t, 4>* ends; ///< of each node
};

TOWFORM_VECTOR_CLONES
void gather(const Patches& p, int nodes, const Padded* __restrict x, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    Vec4 warp{}, weft{};
    const YarnPair* weight = p.weight + p.weights_of[n];
    for (int t = p.first[n]; t < p.first[n + 1]; ++t, ++weight) {
      const Vec4 at = x[p.point[t]].v;
      warp += weight->warp * at;
      weft += weight->weft * at;
    }
    const auto [a0, a1, b0, b1] = p.ends[n];
    const Vec4 a = x[a1].v - x[a0].v, b = x[b1].v - x[b0].v;
    l.warp_x[n] = warp[0];
    l.warp_y[n] = warp[1];
    l.warp_z[n] = warp[2];
    l.weft_x[n] = weft[0];
    l.weft_y[n] = weft[1];
    l.weft_z[n] = weft[2];
    l.ax[n] = a[0];
    l.ay[n] = a[1];
    l.az[n] = a[2];
    l.bx[n] = b[0];
    l.by[n] = b[1];
    l.bz[n] = b[2];
  }
}

TOWFORM_VECTOR_CLONES
void curve(int nodes, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    const double cx = l.ay[n] * l.bz[n] - l.az[n] * l.by[n], cy = l.az[n] * l.bx[n] - l.ax[n] * l.bz[n],
                 cz = l.ax[n] * l.by[n] - l.ay[n] * l.bx[n];
    const double inverse = 1.0 / std::sqrt(cx * cx + cy * cy + cz * cz);
    l.inverse[n] = inverse;
    const double nx = inverse * cx, ny = inverse * cy, nz = inverse * cz;
    l.nx[n] = nx;
    l.ny[n] = ny;
    l.nz[n] = nz;
    l.warp_now[n] = nx * l.warp_x[n] + ny * l.warp_y[n] + nz * l.warp_z[n];
    l.weft_now[n] = nx * l.weft_x[n] + ny * l.weft_y[n] + nz * l.weft_z[n];
  }
}

/// dkappa = n . d(x,ii) + x,ii . dn, of which only the part in the surface turns the normal.
TOWFORM_VECTOR_CLONES
void turn(int nodes, BendingLanes& __restrict l)
{
  for (int n = 0; n < nodes; ++n) {
    const double warp = l.inverse[n] * l.warp_moment[n], weft = l.inverse[n] * l.weft_moment[n];
    const double along = warp * l.warp_now[n] + weft * l.weft_now[n];
    const double tx = warp * l.warp_x[n] + weft * l.weft_x[n] - along * l.nx[n];
    const double ty = warp * l.warp_y[n] + weft * l.weft_y[n] - along * l.ny[n];
    const double tz = warp * l.warp_z[n] + weft * l.weft_z[n] - along * l.nz[n];
    l.on_ax[n] = l.by[n] * tz - l.bz[n] * ty;
    l.on_ay[n] = l.bz[n] * tx - l.bx[n] * tz;
    l.on_az[n] = l.bx[n] * ty - l.by[n] * tx;
    l.on_bx[n] = ty * l.az[n] - tz * l.ay[n];
    l.on_by[n] = tz * l.ax[n] - tx * l.az[n];
    l.on_bz[n] = tx * l.ay[n] - ty * l.ax[n];
  }
}

TOWFORM_VECTOR_CLONES
void add_forces(const Patches& p, int nodes, const BendingLanes& __restrict l, Padded* __restrict force)
{
  for (int n = 0; n < nodes; ++n) {
    const Vec4 normal{l.nx[n], l.ny[n], l.nz[n], 0.0};
    const Vec4 warp = l.warp_moment[n] * normal, weft = l.weft_moment[n] * normal;
    const YarnPair* weight = p.weight + p.weights_of[n];
    for (int t = p.first[n]; t < p.first[n + 1]; ++t, ++weight)
      force[p.point[t]].v -= weight->warp * warp + weight->weft * weft;
    const auto [a0, a1, b0, b1] = p.ends[n];
    const Vec4 on_a{l.on_ax[n], l.on_ay[n], l.on_az[n], 0.0}, on_b{l.on_bx[n], l.on_by[n], l.on_bz[n], 0.0};
    force[a0].v += on_a;
    force[a1].v -= on_a;
    force[b0].v += on_b;
    force[b1].v -= on_b;
  }
}

/// Moments of the curvatures, now or in the middle of the time for which they are held; returns the energy lost in damping.
/// dt from one look at the curvatures to the next.
double bend(const Bending& bending, int first, int nodes, double dt, YarnPair* curvature, BendingLanes& l)
{
  const double ahead = held_ahead(bending.interval);
  const double warp_viscosity = bending.warp.stiffness() * bending.damping_time / dt;
  const double weft_viscosity = bending.weft.stiffness() * bending.damping_time / dt;
  double lost = 0.0;
  for (int n = 0; n < nodes; ++n) {
    const double area = bending.area[first + n];
    const YarnPair now{l.warp_now[n], l.weft_now[n]};
    const YarnPair change{now.warp - curvature[n].warp, now.weft - curvature[n].weft};
    l.warp_moment[n] = area * (bending.warp.moment(now.warp + ahead * change.warp) + warp_viscosity * change.warp);
    l.weft_moment[n] = area * (bending.weft.moment(now.weft + ahead * change.weft) + weft_viscosity * change.weft);
    lost += area * (warp_viscosity * change.warp * change.warp + weft_viscosity * change.weft * change.weft);
    curvature[n] = now;
  }
  return lost;
}

/// What a thread needs to compute a block.
struct BendingWork {
  std::vector<Padded> position, force;
  BendingLanes lanes;

  static BendingWork& here()
  {
    static thread_local BendingWork work;
    return work;
  }
  void take(std::span<const int> points, const ImagedPositions& x)
  {
    position.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) position[i].set(x[points[i]]);
  }
  /// Adds the block's forces, from its lanes.
  void give(const Bending& bending, const CurvatureOperator::Block& block, std::span<Vec3> block_force, std::span<Vec3> of_all)
  {
    force.assign(static_cast<std::size_t>(block.points.count), {});
    add_forces(patches(bending, block), block.nodes, lanes, force.data());
    const BlockSlots& slots = bending.curvature.slots;
    for (int i = 0; i < block.points.count; ++i) {
      Vec3& to = slots.target(block.points, i, of_all, block_force);
      to = slots.reaches_alone(block.points, i) ? to + force[i].vec3() : force[i].vec3();
    }
  }
  static Patches patches(const Bending& bending, const CurvatureOperator::Block& block)
  {
    const CurvatureOperator& c = bending.curvature;
    return {c.first.data() + block.first_node, c.point.data(), c.weights_of.data() + block.first_node, c.weight.data(),
            c.ends.data() + block.first_node};
  }
};

void bend_block(const Bending& bending, int number, double dt, BendingState& b, State& s, std::span<Vec3> force)
{
  const CurvatureOperator::Block& block = bending.curvature.blocks[number];
  BendingWork& w = BendingWork::here();
  w.take(bending.curvature.slots.points(block.points), {s.position, b.image});
  gather(BendingWork::patches(bending, block), block.nodes, w.position.data(), w.lanes);
  curve(block.nodes, w.lanes);
  b.damping[number] += bend(bending, block.first_node, block.nodes, dt, b.curvature.data() + block.first_node, w.lanes);
  turn(block.nodes, w.lanes);
  w.give(bending, block, s.block_force, force);
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
  const double warp_stiffness = factor * bending.warp.stiffness(), weft_stiffness = factor * bending.weft.stiffness();
  parallel_each(static_cast<int>(bending.curvature.blocks.size()), [&](int number) {
    const CurvatureOperator::Block& block = bending.curvature.blocks[number];
    const std::span<const int> points = bending.curvature.slots.points(block.points);
    const Patches patches = BendingWork::patches(bending, block);
    BendingWork& w = BendingWork::here();
    w.take(points, {position, image});
    gather(patches, block.nodes, w.position.data(), w.lanes);
    curve(block.nodes, w.lanes);
    w.take(points, {motion, image_motion});
    BendingLanes& l = w.lanes;
    for (int n = 0; n < block.nodes; ++n) { // the normals stay, the rest is the motion's
      Vec4 warp{}, weft{};
      const YarnPair* weight = patches.weight + patches.weights_of[n];
      for (int t = patches.first[n]; t < patches.first[n + 1]; ++t, ++weight) {
        warp += weight->warp * w.position[patches.point[t]].v;
        weft += weight->weft * w.position[patches.point[t]].v;
      }
      const double area = bending.area[block.first_node + n];
      l.warp_moment[n] = area * warp_stiffness * (l.nx[n] * warp[0] + l.ny[n] * warp[1] + l.nz[n] * warp[2]);
      l.weft_moment[n] = area * weft_stiffness * (l.nx[n] * weft[0] + l.ny[n] * weft[1] + l.nz[n] * weft[2]);
      l.on_ax[n] = l.on_ay[n] = l.on_az[n] = l.on_bx[n] = l.on_by[n] = l.on_bz[n] = 0.0;
    }
    w.give(bending, block, block_force, force);
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
