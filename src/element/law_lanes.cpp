#include "element/membrane_lanes.hpp"
#include "parallel/vector_clones.hpp"
#include <bit>
#include <cmath>
#include <cstring>

namespace towform {

namespace {

/// Elements whose place in the table is looked for.
struct TableLanes {
  static constexpr int size = MembraneBatch::size;
  // NOLINTBEGIN(modernize-avoid-c-arrays)
  alignas(64) double weight[size], trial[size], rate[size];
  alignas(64) std::int64_t cell[size], unsettled[size];
  alignas(64) std::uint64_t low[size], high[size]; ///< two forces each, in single precision
  alignas(64) std::int32_t row[size], place[size];
  std::int32_t index[size]; ///< in the batch
  // NOLINTEND(modernize-avoid-c-arrays)
};

/// What vectors fill: loops over the last ones meet no rest. Lanes beyond the count hold any element's numbers.
constexpr int whole_vectors(int count) { return (count + 7) / 8 * 8; }

TOWFORM_VECTOR_CLONES
void begin(double cells_per_radian, double modulus, const ShearLanes& old, int count, MembraneBatch& __restrict b,
           TableLanes& __restrict t)
{
  const double* __restrict old_angle = old.angle;
  const double* __restrict old_force = old.force;
  const double* __restrict old_rate = old.rate;
  for (int i = 0; i < count; ++i) {
    t.trial[i] = b.force[i] = old_force[i] + modulus * (b.angle[i] - old_angle[i]);
    const ShearTable::Row row = ShearTable::row_of(b.angle[i], cells_per_radian);
    t.weight[i] = row.weight;
    t.row[i] = row.first;
    t.rate[i] = old_rate[i];
    t.index[i] = i;
  }
  for (int i = count; i < whole_vectors(count); ++i) {
    t.weight[i] = t.trial[i] = t.rate[i] = 0.0;
    t.row[i] = 0;
  }
}

TOWFORM_VECTOR_CLONES
void find_cells(int count, TableLanes& __restrict t)
{
  for (int i = 0; i < whole_vectors(count); ++i) {
    const std::int64_t cell = ShearTable::cell_of(t.rate[i]);
    t.cell[i] = cell;
    t.place[i] = t.row[i] + static_cast<std::int32_t>(cell);
  }
}

void read_table(const float* forces, int count, TableLanes& t)
{
  for (int i = 0; i < whole_vectors(count); ++i) {
    const float* low = forces + t.place[i];
    std::memcpy(&t.low[i], low, sizeof t.low[i]);
    std::memcpy(&t.high[i], low + ShearTable::rate_points, sizeof t.high[i]);
  }
}

TOWFORM_VECTOR_CLONES
void solve(double spring, int count, TableLanes& __restrict t)
{
  for (int i = 0; i < whole_vectors(count); ++i) {
    const auto first = [](std::uint64_t pair) {
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(pair)));
    };
    const auto second = [](std::uint64_t pair) {
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(pair >> 32)));
    };
    const ShearTable::Root root =
        ShearTable::solve(first(t.low[i]), second(t.low[i]), first(t.high[i]), second(t.high[i]), t.weight[i],
                          t.cell[i], t.rate[i], std::abs(t.trial[i]), spring);
    t.rate[i] = root.rate;
    t.unsettled[i] = root.unsettled;
  }
}

/// The first look at the table tells most rates.
TOWFORM_VECTOR_CLONES
void take_all(int count, const TableLanes& __restrict t, MembraneBatch& __restrict b)
{
  for (int i = 0; i < count; ++i) b.rate[i] = t.rate[i];
}

void take_those_left(int count, const TableLanes& t, MembraneBatch& b)
{
  for (int i = 0; i < count; ++i) b.rate[t.index[i]] = t.rate[i];
}

/// Which are unsettled, a bit each.
TOWFORM_VECTOR_CLONES
std::uint64_t unsettled(int count, const TableLanes& t)
{
  static_assert(TableLanes::size <= 64);
  std::uint64_t bits = 0;
  for (int i = 0; i < count; ++i) bits |= static_cast<std::uint64_t>(t.unsettled[i]) << i;
  return bits;
}

/// Moves the unsettled ones to the front; returns how many.
int keep_unsettled(int count, TableLanes& t)
{
  int left = 0;
  for (std::uint64_t bits = unsettled(count, t); bits != 0; bits &= bits - 1) {
    const int i = std::countr_zero(bits);
    t.weight[left] = t.weight[i];
    t.trial[left] = t.trial[i];
    t.rate[left] = t.rate[i];
    t.row[left] = t.row[i];
    t.index[left] = t.index[i];
    ++left;
  }
  return left;
}

/// The batch's forces, so far those without flow.
TOWFORM_VECTOR_CLONES
void finish(double spring, int count, MembraneBatch& __restrict b)
{
  for (int i = 0; i < count; ++i) {
    const double trial = b.force[i];
    const double force = std::copysign(std::abs(trial) - spring * b.rate[i], trial);
    b.force[i] = force;
    b.lost[i] = std::abs(force) * b.rate[i];
  }
}

} // namespace

void update(const ViscousLaw& law, const ShearLanes& old, MembraneBatch& b, int count, double dt)
{
  TableLanes t;
  const double spring = law.modulus * dt;
  begin(law.surface->cells_per_radian(), law.modulus, old, count, b, t);
  int left = count;
  for (int round = 0; round < ViscousLaw::most_rounds && left > 0; ++round) {
    find_cells(left, t);
    read_table(law.surface->forces(), left, t);
    solve(spring, left, t);
    if (round == 0)
      take_all(left, t, b);
    else
      take_those_left(left, t, b);
    left = keep_unsettled(left, t);
  }
  finish(spring, count, b);
}

TOWFORM_VECTOR_CLONES
void update(const ElasticLaw& law, const ShearLanes& old, MembraneBatch& __restrict b, int count, double dt)
{
  const double* __restrict old_angle = old.angle;
  const ShearCurve curve = law.curves->curves.front();
  const double at_joint = curve.force(ElasticLaw::joint);
  for (int i = 0; i < count; ++i) {
    b.rate[i] = std::abs(b.angle[i] - old_angle[i]) / dt;
    b.force[i] = ElasticLaw::force(curve, at_joint, b.angle[i]);
    b.lost[i] = 0.0;
  }
}

} // namespace towform
