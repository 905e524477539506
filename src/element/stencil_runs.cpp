#include "element/stencil_runs.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace towform {

namespace {

/// The patch that most nodes have.
std::size_t commonest(std::span<const CurvaturePatch> patches)
{
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return patches[a].key < patches[b].key; });
  std::size_t best = order.front(), most = 0;
  for (auto first = order.begin(); first != order.end();) {
    const auto end = std::find_if(first, order.end(), [&](std::size_t i) { return patches[i].key != patches[*first].key; });
    if (static_cast<std::size_t>(end - first) > most) {
      most = static_cast<std::size_t>(end - first);
      best = *first;
    }
    first = end;
  }
  return best;
}

/// Cells that half the chords of a node span, and the place of each point in their rows.
class PatchLattice {
public:
  PatchLattice(const CurvaturePatch& patch, const Vec3& origin, std::span<const int> points, std::span<const Vec3> flat)
  {
    const auto& [a0, a1, b0, b1] = patch.ends;
    const Vec3 along = 0.5 * (flat[a1] - flat[a0]), across = 0.5 * (flat[b1] - flat[b0]);
    const double cell = cross(along, across).z;
    constexpr double none = 1e-300;
    if (!(std::abs(cell) > none)) return;
    std::vector<std::optional<Place>> places;
    Place low{0, 0}, high{0, 0};
    for (const int p : points) {
      const Vec3 d = flat[p] - origin;
      const double column = cross(d, across).z / cell, row = cross(along, d).z / cell;
      constexpr double rounding = 1e-6, far = 1e6;
      const bool fits = std::abs(column) < far && std::abs(row) < far && std::abs(column - std::round(column)) < rounding &&
                        std::abs(row - std::round(row)) < rounding;
      places.emplace_back();
      if (!fits) continue;
      const Place place{static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row))};
      places.back() = place;
      low = {std::min(low.column, place.column), std::min(low.row, place.row)};
      high = {std::max(high.column, place.column), std::max(high.row, place.row)};
    }
    const std::int64_t columns = high.column - low.column + 1, count = columns * (high.row - low.row + 1);
    if (count > StencilLayout::most_lanes) return;
    in_rows = lanes = static_cast<int>(count);
    std::vector<char> is_taken(static_cast<std::size_t>(count), 0); // images behind an edge may lie on other parts of the sheet
    for (const std::optional<Place>& place : places) {
      const std::int64_t in_row = place ? (place->row - low.row) * columns + (place->column - low.column) : count;
      const bool has_place = place && std::exchange(is_taken[static_cast<std::size_t>(in_row)], 1) == 0;
      lane.push_back(static_cast<std::uint16_t>(has_place ? in_row : lanes++));
    }
    if (lanes > StencilLayout::most_lanes) lanes = 0;
  }

  int lanes = 0, in_rows = 0; ///< the first ones are in rows
  std::vector<std::uint16_t> lane;

private:
  struct Place {
    int column, row;
  };
};

/// Where a node's terms and chords are, by lanes ahead of its own.
struct Reach {
  std::vector<int> terms; ///< ascending
  std::array<int, 4> ends{};
  auto operator<=>(const Reach&) const = default;
};

/// A node that may be in a run.
struct Member {
  int node, lane;
  std::vector<int> ahead; ///< of the terms, in the patch's order
};

using Weights = std::vector<double>; ///< in the order of a reach's terms

double product(const Weights& a, const Weights& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

/// a + factor b
Weights sum(Weights a, double factor, const Weights& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  return a;
}

/// A member's weights, warp and weft.
using FamilyWeights = std::array<Weights, 2>;

FamilyWeights weights_of(const CurvaturePatch& patch, const Reach& reach, const Member& m)
{
  FamilyWeights weights{Weights(reach.terms.size()), Weights(reach.terms.size())};
  for (std::size_t i = 0; i < m.ahead.size(); ++i) {
    const auto term = static_cast<std::size_t>(std::lower_bound(reach.terms.begin(), reach.terms.end(), m.ahead[i]) - reach.terms.begin());
    weights[0][term] = patch.weights[i].warp;
    weights[1][term] = patch.weights[i].weft;
  }
  return weights;
}

/// Weights that members have but for multiples of one vector.
class CommonWeights {
public:
  explicit CommonWeights(std::span<const FamilyWeights> all) : base_(all.front()), change_(base_[0].size(), 0.0)
  {
    for (const Weights& weights : base_)
      for (const double w : weights) rounding_ = std::max(rounding_, CurvaturePatch::rounding * std::abs(w));
    double farthest = rounding_;
    for (const FamilyWeights& its : all)
      for (std::size_t f = 0; f < 2; ++f) {
        Weights difference = sum(its[f], -1.0, base_[f]);
        const double size = std::sqrt(product(difference, difference));
        if (size <= farthest) continue;
        farthest = size;
        change_ = std::move(difference);
      }
    varies_ = farthest > rounding_;
    for (double& c : change_) {
      c /= farthest;
      constexpr double nothing = 1e-9;
      if (std::abs(c) < nothing) c = 0.0;
    }
    for (Weights& weights : base_) weights = sum(weights, -product(weights, change_), change_);
  }
  [[nodiscard]] bool varies() const { return varies_; }
  /// By what the change is multiplied; nothing where that does not give the weights.
  [[nodiscard]] std::optional<YarnPair> times(const FamilyWeights& weights) const
  {
    std::array<double, 2> times{};
    for (std::size_t f = 0; f < 2; ++f) {
      const Weights difference = sum(weights[f], -1.0, base_[f]);
      times[f] = product(difference, change_);
      const Weights rest = sum(difference, -times[f], change_);
      if (std::any_of(rest.begin(), rest.end(), [&](double r) { return std::abs(r) > rounding_; })) return std::nullopt;
    }
    return YarnPair{times[0], times[1]};
  }
  /// What is rounding alone goes to the node's own weight, so that the sum stays.
  [[nodiscard]] std::vector<StencilPoint> points(const Reach& reach) const
  {
    FamilyWeights weights = base_;
    const auto own = static_cast<std::size_t>(std::lower_bound(reach.terms.begin(), reach.terms.end(), 0) - reach.terms.begin());
    for (Weights& its : weights)
      for (double& w : its)
        if (std::abs(w) <= rounding_) its[own] += std::exchange(w, 0.0);
    std::vector<StencilPoint> points;
    for (std::size_t i = 0; i < change_.size(); ++i) points.push_back({reach.terms[i], weights[0][i], weights[1][i], change_[i]});
    return points;
  }

private:
  FamilyWeights base_;
  Weights change_;
  double rounding_ = 0.0;
  bool varies_ = false;
};

constexpr std::size_t fewest = 16;  // nodes that make a run worth its while
constexpr double least_part = 0.3;  // of its lanes that are nodes of it

/// The run of members with the same reach, ascending by their lanes; nothing where that is not worth its while.
std::optional<StencilRun> run_of(std::span<const CurvaturePatch> patches, const Reach& reach, std::vector<Member> members)
{
  std::vector<FamilyWeights> weights;
  for (const Member& m : members) weights.push_back(weights_of(patches[static_cast<std::size_t>(m.node)], reach, m));
  const CommonWeights common(weights);
  std::vector<YarnPair> times;
  std::size_t fit = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::optional<YarnPair> its = common.times(weights[i]);
    if (!its) continue;
    times.push_back(*its);
    members[fit++] = members[i];
  }
  members.resize(fit);
  if (fit < fewest) return std::nullopt;
  StencilRun run;
  run.first_lane = members.front().lane;
  const int count = members.back().lane - run.first_lane + 1;
  if (static_cast<double>(fit) < least_part * count) return std::nullopt;
  constexpr int size = StencilLayout::vector_size;
  run.nodes.assign(static_cast<std::size_t>((count + size - 1) / size * size), -1);
  if (common.varies()) run.times.assign(run.nodes.size(), {});
  for (std::size_t i = 0; i < fit; ++i) {
    const auto place = static_cast<std::size_t>(members[i].lane - run.first_lane);
    run.nodes[place] = members[i].node;
    if (common.varies()) run.times[place] = times[i];
  }
  run.ends = reach.ends;
  run.points = common.points(reach);
  return run;
}

} // namespace

StencilLayout find_runs(std::span<const CurvaturePatch> patches, int first_node, std::span<const int> points,
                        std::span<const Vec3> flat)
{
  if (patches.size() < fewest) return {};
  const std::size_t origin = commonest(patches);
  PatchLattice lattice(patches[origin], flat[static_cast<std::size_t>(first_node) + origin], points, flat);
  if (lattice.lanes == 0) return {};
  const auto lane_of = [&](int point) {
    return static_cast<int>(lattice.lane[static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), point) - points.begin())]);
  };
  /// Lanes ahead of a node's own; nothing where a point has none.
  const auto ahead_of = [&](int own, const auto& its_points) {
    std::vector<int> ahead;
    for (const int p : its_points) {
      const int lane = lane_of(p);
      if (lane >= lattice.in_rows) return std::vector<int>{};
      ahead.push_back(lane - own);
    }
    return ahead;
  };
  std::map<Reach, std::vector<Member>> alike;
  for (std::size_t n = 0; n < patches.size(); ++n) {
    const CurvaturePatch& patch = patches[n];
    const int node = static_cast<int>(n), own = lane_of(first_node + node);
    const std::vector<int> ahead = ahead_of(own, patch.points), ends = ahead_of(own, patch.ends);
    if (own >= lattice.in_rows || ahead.empty() || ends.empty()) continue;
    Reach reach{ahead, {}};
    std::sort(reach.terms.begin(), reach.terms.end());
    if (ends[0] <= ends[1]) // turning both chords round leaves the normal
      reach.ends = {ends[0], ends[1], ends[2], ends[3]};
    else
      reach.ends = {ends[1], ends[0], ends[3], ends[2]};
    alike[reach].push_back({node, own, ahead});
  }
  StencilLayout layout;
  for (auto& [reach, members] : alike) {
    if (members.size() < fewest) continue;
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.lane < b.lane; });
    if (auto run = run_of(patches, reach, std::move(members))) layout.runs.push_back(std::move(*run));
  }
  if (layout.runs.empty()) return {};
  layout.lanes = lattice.lanes;
  layout.lane = std::move(lattice.lane);
  return layout;
}

} // namespace towform
