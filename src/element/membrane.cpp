#include "element/membrane.hpp"
#include "element/arcsine.hpp"
#include "element/membrane_work.hpp"
#include "element/strip_lattice.hpp"
#include "mesh/element_shapes.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace towform {

FlatTriangle flat_triangle(const Blank& blank, const Triangle& t)
{
  const auto& [a, b, c] = t;
  const Vec3 d1 = blank.mesh.points[b] - blank.mesh.points[a], d2 = blank.mesh.points[c] - blank.mesh.points[a];
  const double twice = d1.x * d2.y - d1.y * d2.x;
  if (!(twice > 0.0)) throw std::invalid_argument("a blank element has no area or is turned over");
  const Vec3 grad_1 = {d2.y / twice, -d2.x / twice, 0.0}, grad_2 = {-d1.y / twice, d1.x / twice, 0.0};
  return {{dot(grad_1, blank.warp), dot(grad_2, blank.warp), dot(grad_1, blank.weft), dot(grad_2, blank.weft)}, 0.5 * twice};
}

Membrane::Membrane(const Blank& blank, const YarnLaw& yarn_law, FabricLaw fabric_law, YarnStrain yarn_strain)
    : triangles(blank.mesh.triangles), node_area(blank.mesh.points.size(), 0.0),
      reference_sine(dot(blank.warp, blank.weft)), thickness(blank.thickness), yarn(yarn_law), law(std::move(fabric_law))
{
  std::vector<FlatTriangle> flat;
  flat.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    flat.push_back(flat_triangle(blank, t));
    for (const int node : t) node_area[node] += flat.back().area / 3.0;
  }
  const bool own =
      yarn_strain == YarnStrain::triangle || (yarn_strain == YarnStrain::automatic && follows_yarns(blank));
  std::vector<double> area;
  area.reserve(flat.size());
  for (const FlatTriangle& t : flat) area.push_back(t.area);
  strips = own ? strips_of_one(area) : lay_strips(blank, area);
  const std::vector<int> shape = element_shapes(blank.mesh);
  blocks = ElementBlocks(triangles, shape, node_area.size(), blank.tiles.triangles, strips);
  batches = MembraneBatches(blocks, shape, flat);
  // What has been laid out is known by blocks.
  blocks.element = {};
  strips.entry = {};
}

StripEntries Membrane::entries(const ElementBlocks::Block& b) const
{
  return {strips.first.data() + b.first_strip, blocks.entry.data(), b.strips};
}

std::vector<double> Membrane::areas() const
{
  std::vector<double> area(triangles.size());
  for (int block = 0; block < blocks.count(); ++block)
    each_own(block, [&](std::size_t e, const FlatTriangle& flat) { area[e] = flat.area; });
  return area;
}

double Membrane::yarn_energy(const State& s) const
{
  const double of_strips = parallel_sum(strips.size(), [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += strips.area[i] * yarn.energy(s.strip_strain[i]);
    return sum;
  });
  std::vector<double> of_springs(blocks.blocks.size());
  parallel_each(blocks.count(), [&](int number) {
    each_own(number, [&](std::size_t e, const FlatTriangle& flat) {
      const YarnVectors y(triangles[e], flat.gradients, s.position);
      const double warp = y.lambda1 - 1.0 - s.strip_strain[strips.of[2 * e]];
      const double weft = y.lambda2 - 1.0 - s.strip_strain[strips.of[2 * e + 1]];
      of_springs[number] += 0.5 * own_stiffness * flat.area * (warp * warp + weft * weft);
    });
  });
  return std::accumulate(of_springs.begin(), of_springs.end(), of_strips);
}

void start(const Membrane& membrane, State& s)
{
  const std::size_t m = membrane.triangles.size(), blocks = membrane.blocks.blocks.size();
  s.strip_strain.assign(membrane.strips.size(), 0.0);
  s.sine.assign(m, membrane.reference_sine);
  for (std::vector<double>* v : {&s.shear_angle, &s.shear_force, &s.shear_rate}) v->assign(m, 0.0);
  s.block_force.assign(membrane.blocks.slots.count(), {});
  s.shear_work.assign(blocks, 0.0);
  s.shear_dissipated.assign(blocks, 0.0);
  s.yarn_damping.assign(blocks, 0.0);
}

namespace {

/// Any law, point by point.
template <class Law>
void update(const Law& law, const ShearLanes& old, MembraneBatch& b, int count, double dt)
{
  for (int i = 0; i < count; ++i) {
    ShearPoint p{old.angle[i], old.force[i], old.rate[i]};
    b.lost[i] = law.update(p, b.angle[i], dt);
    b.force[i] = p.force;
    b.rate[i] = p.rate;
  }
}

/// One block's forces.
template <class Law>
class BlockWork {
public:
  BlockWork(const Membrane& membrane, const Law& law, State& s, double dt, int number, Workplace& w)
      : membrane_(membrane), law_(law), s_(s), dt_(dt), number_(number), w_(w),
        block_(membrane.blocks.blocks[number]), corner_(membrane.blocks.corners(block_)),
        spring_(membrane.own_stiffness), reference_angle_(arcsine(membrane.reference_sine))
  {
  }

  void go()
  {
    const MembraneBatches& batches = membrane_.batches;
    w_.take(membrane_.blocks.slots.points(block_.nodes), s_.position);
    for (const Batch& b : batches.all(number_)) {
      gather_edges(w_.position.data(), corner_ + 3 * b.first, b.count, w_.batch);
      yarn_vectors(batches.coefficients(b), w_.batch, b.first, b.count, w_.lanes);
    }
    tension_of_strips();
    double work = 0.0, dissipated = 0.0;
    for (const Batch& b : batches.own(number_)) {
      const MembraneCoefficients c = batches.coefficients(b);
      shear(c, b);
      shear_and_tension(c, spring_, w_.lanes, b.first, b.count, w_.batch);
      work += sum(w_.batch.work, b.count);
      dissipated += sum(w_.batch.dissipated, b.count);
      add_forces(w_.batch, corner_ + 3 * b.first, b.count, w_.force.data());
    }
    for (const Batch& b : batches.guests(number_)) {
      tension(batches.coefficients(b), spring_, w_.lanes, b.first, b.count, w_.batch);
      add_forces(w_.batch, corner_ + 3 * b.first, b.count, w_.force.data());
    }
    s_.shear_work[number_] += work;
    s_.shear_dissipated[number_] += dissipated;
    w_.give(membrane_.blocks.slots, block_.nodes, s_.block_force, s_.force);
  }

private:
  using Batch = MembraneBatches::Batch;

  /// Tensions of the block's strips, handed to their entries.
  void tension_of_strips()
  {
    const YarnStrips& all = membrane_.strips;
    const StripEntries entries = membrane_.entries(block_);
    sum_strips(entries, w_.lanes, w_.strips);
    const double viscosity = membrane_.yarn.stiffness * membrane_.damping_time / dt_;
    strip_tensions(membrane_.yarn, viscosity, spring_, all.area.data() + block_.first_strip,
                   s_.strip_strain.data() + block_.first_strip, block_.strips, w_.strips);
    hand_out(entries, w_.strips, w_.lanes);
    leave_out(membrane_.blocks.entries_of_others(block_), w_.lanes);
    s_.yarn_damping[number_] += sum(w_.strips.lost, block_.strips);
  }

  /// Advances the law's points.
  void shear(const MembraneCoefficients& c, const Batch& b)
  {
    const std::ptrdiff_t e = block_.first_element + b.first;
    const ShearLanes state{s_.sine.data() + e, s_.shear_angle.data() + e, s_.shear_force.data() + e,
                           s_.shear_rate.data() + e};
    shear_angles(w_.lanes, b.first, b.count, reference_angle_, w_.batch);
    update(law_, state, w_.batch, b.count, dt_);
    keep(c.area, dt_, b.count, w_.batch, state);
  }

  const Membrane& membrane_;
  const Law& law_;
  State& s_;
  double dt_;
  int number_;
  Workplace& w_;
  const ElementBlocks::Block& block_;
  const std::uint16_t* corner_;
  double spring_, reference_angle_;
};

} // namespace

void membrane_forces(const Membrane& membrane, State& s, double dt)
{
  std::visit(
      [&](const auto& law) {
        parallel_each(membrane.blocks.count(), [&](int number) {
          static thread_local const std::unique_ptr<Workplace> workplace = std::make_unique<Workplace>();
          BlockWork(membrane, law, s, dt, number, *workplace).go();
        });
      },
      membrane.law);
}

void assemble(const ElementBlocks& blocks, std::span<const Vec3> block_force, std::span<Vec3> force)
{
  const std::span<const int> nodes = blocks.slots.summed();
  parallel_ranges(static_cast<std::ptrdiff_t>(nodes.size()), [&](auto begin, auto end) {
    for (auto i = begin; i < end; ++i) force[nodes[i]] = blocks.slots.sum(block_force, i);
  });
}

} // namespace towform
