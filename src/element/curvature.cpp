#include "element/curvature.hpp"
#include "element/chords.hpp"
#include "element/moment_balance.hpp"
#include "mesh/outline.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace towform {

namespace {

/// Symmetry lines of a blank: its mirror planes and the clamped edges.
std::vector<SymmetryLine> lines_of(const Blank& blank, std::span<const SymmetryLine> clamped)
{
  std::vector<SymmetryLine> lines(clamped.begin(), clamped.end());
  lines.push_back({SymmetryLine::Across::x, blank.mirror_x});
  lines.push_back({SymmetryLine::Across::y, blank.mirror_y});
  return lines;
}

std::vector<double> areas_of(const SurfaceMesh& flat)
{
  std::vector<double> area(flat.points.size(), 0.0);
  for (const auto& [a, b, c] : flat.triangles) {
    const double sixth = cross(flat.points[b] - flat.points[a], flat.points[c] - flat.points[a]).z / 6.0;
    for (const int n : {a, b, c}) area[n] += sixth;
  }
  return area;
}

std::vector<char> on_outline(const SurfaceMesh& flat)
{
  std::vector<char> is_on(flat.points.size(), 0);
  for (const auto& edge : outline_edges(flat.triangles))
    for (const int n : edge) is_on[n] = 1;
  return is_on;
}

/// Where blocks of nodes begin, and the number of nodes: tiles of the mesh, cut where they are too large.
std::vector<int> block_starts(std::span<const int> tiles, int nodes)
{
  std::vector<int> starts{0};
  while (starts.back() < nodes) {
    const auto next = std::upper_bound(tiles.begin(), tiles.end(), starts.back());
    const int end = next == tiles.end() ? nodes : std::min(*next, nodes), count = end - starts.back();
    constexpr int most = CurvatureOperator::most_nodes;
    starts.push_back(starts.back() + (count <= most ? count : std::min(most, (count + 1) / 2)));
  }
  return starts;
}

} // namespace

/// Finds weights that are there already.
class CurvatureOperator::SharedWeights {
public:
  explicit SharedWeights(std::vector<YarnPair>& all) : all_(all) {}

  /// Where a patch's weights begin.
  int place(const CurvaturePatch& patch)
  {
    const auto [at, is_new] = known_.try_emplace(patch.key, static_cast<int>(all_.size()));
    if (is_new) all_.insert(all_.end(), patch.weights.begin(), patch.weights.end());
    return at->second;
  }

private:
  struct Hash {
    std::size_t operator()(const std::vector<std::int64_t>& key) const
    {
      std::uint64_t sum = 0xcbf29ce484222325ULL; // FNV-1a, by words
      for (const std::int64_t k : key) sum = (sum ^ static_cast<std::uint64_t>(k)) * 0x100000001b3ULL;
      return static_cast<std::size_t>(sum ^ sum >> 32);
    }
  };
  std::vector<YarnPair>& all_;
  std::unordered_map<std::vector<std::int64_t>, int, Hash> known_;
};

/// A block's nodes, before it is given its places.
struct CurvatureOperator::Laid {
  int first_node = 0;
  std::vector<int> points; ///< ascending
  StencilLayout layout;
};

CurvatureOperator::CurvatureOperator(const Blank& blank, std::span<const SymmetryLine> clamped, int balance)
{
  const MirroredSheet sheet(blank.mesh, lines_of(blank, clamped));
  images = sheet.images;
  std::vector<QuadraticFit> fits(sheet.nodes);
  std::vector<std::array<int, 4>> chords(sheet.nodes);
  const std::vector<char> outline = on_outline(blank.mesh);
  const std::array<Vec3, 2> directions{blank.warp, blank.weft};
  std::array<DirectionalWeights, 2> weights;
  for (DirectionalWeights& w : weights) w.resize(sheet.nodes);
  parallel_ranges(static_cast<std::ptrdiff_t>(sheet.nodes), [&](auto begin, auto end) {
    for (auto n = begin; n < end; ++n) {
      fits[n] = quadratic_fit(sheet, static_cast<int>(n));
      chords[n] = chords_of(sheet, static_cast<int>(n), blank.warp);
      for (std::size_t d = 0; d < 2; ++d) {
        const Vec3& f = directions[d];
        weights[d][n].reserve(fits[n].weights.size());
        for (const QuadraticFit::Weights& w : fits[n].weights)
          weights[d][n].push_back(f.x * f.x * w.xx + 2.0 * f.x * f.y * w.xy + f.y * f.y * w.yy);
      }
      // Slopes are wanted on the outline alone, and would be most of what set-up needs memory for.
      if (outline[n] == 0) std::vector<QuadraticFit::Weights>().swap(fits[n].weights);
    }
  });
  const bool fitted =
      std::all_of(fits.begin(), fits.end(), [](const QuadraticFit& fit) { return !fit.points.empty(); });
  const std::vector<double> area = areas_of(blank.mesh);
  if (balance > 0 && fitted) {
    std::array<double, 2> left{};
    parallel_each(2, [&](int d) { left[d] = balance_moments(sheet, blank.mesh, fits, area, directions[d], balance, weights[d]); });
    imbalance = std::max(left[0], left[1]);
  }
  // Some blocks at a time: all patches together would be what a fine mesh takes most memory for.
  constexpr std::size_t together = 64;
  const std::vector<int> starts = block_starts(blank.tiles.nodes, static_cast<int>(sheet.nodes));
  nodes_ = sheet.nodes;
  SharedWeights shared(weight);
  first.push_back(0);
  std::vector<std::vector<CurvaturePatch>> patches(together);
  std::vector<Laid> laid(together);
  for (std::size_t begin = 0; begin + 1 < starts.size(); begin += together) {
    const std::size_t count = std::min(together, starts.size() - 1 - begin);
    parallel_each(static_cast<int>(count), [&](int i) {
      const auto block = begin + static_cast<std::size_t>(i);
      patches[i].clear();
      for (auto n = static_cast<std::size_t>(starts[block]); n < static_cast<std::size_t>(starts[block + 1]); ++n)
        patches[i].emplace_back(std::exchange(fits[n].points, {}), std::exchange(weights[0][n], {}),
                                std::exchange(weights[1][n], {}), chords[n]);
      laid[i] = lay_out(patches[i], starts[block], sheet.points);
    });
    for (std::size_t i = 0; i < count; ++i) add_block(patches[i], std::move(laid[i]), shared);
  }
  slots.finish(sheet.nodes); // images hand theirs on
  for (auto* v : {&node, &first, &weights_of}) v->shrink_to_fit();
  for (auto* v : {&point, &lane, &shared_lane}) v->shrink_to_fit();
  times.shrink_to_fit();
  weight.shrink_to_fit();
  ends.shrink_to_fit();
}

CurvatureOperator::Laid CurvatureOperator::lay_out(std::span<const CurvaturePatch> patches, int first_node,
                                                   std::span<const Vec3> flat)
{
  Laid laid;
  laid.first_node = first_node;
  std::vector<int>& points = laid.points;
  for (const CurvaturePatch& patch : patches) {
    points.insert(points.end(), patch.points.begin(), patch.points.end());
    points.insert(points.end(), patch.ends.begin(), patch.ends.end());
  }
  for (std::size_t i = 0; i < patches.size(); ++i) points.push_back(first_node + static_cast<int>(i));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  laid.layout = find_runs(patches, first_node, points, flat);
  return laid;
}

void CurvatureOperator::add_block(std::span<const CurvaturePatch> patches, Laid laid, SharedWeights& shared)
{
  Block b;
  const StencilLayout& layout = laid.layout;
  b.points = slots.add(std::move(laid.points));
  b.first_place = static_cast<int>(node.size());
  b.first_run = static_cast<int>(runs.size());
  b.runs = static_cast<int>(layout.runs.size());
  b.first_single = static_cast<int>(ends.size());
  b.lanes = layout.lanes;
  lane.resize(lane.size() + static_cast<std::size_t>(b.points.count));
  std::copy(layout.lane.begin(), layout.lane.end(), lane.begin() + b.points.first);
  std::vector<char> is_placed(patches.size(), 0);
  for (const StencilRun& run : layout.runs) {
    Run r;
    r.first_lane = run.first_lane;
    r.count = static_cast<int>(run.nodes.size());
    r.first_place = static_cast<int>(node.size());
    r.first_term = static_cast<int>(term.size());
    const auto add_terms = [&](double StencilPoint::* share) {
      const std::size_t before = term.size();
      for (const StencilPoint& p : run.points)
        if (p.*share != 0.0) term.push_back({p.ahead, p.*share});
      return static_cast<int>(term.size() - before);
    };
    r.warp_terms = add_terms(&StencilPoint::warp);
    r.weft_terms = add_terms(&StencilPoint::weft);
    r.change_terms = add_terms(&StencilPoint::change);
    r.first_point = static_cast<int>(run_point.size());
    r.points = static_cast<int>(run.points.size());
    r.first_time = static_cast<int>(times.size());
    r.ends = run.ends;
    runs.push_back(r);
    run_point.insert(run_point.end(), run.points.begin(), run.points.end());
    times.insert(times.end(), run.times.begin(), run.times.end());
    for (const int n : run.nodes) {
      node.push_back(n < 0 ? -1 : laid.first_node + n);
      if (n >= 0) is_placed[static_cast<std::size_t>(n)] = 1;
    }
  }
  std::map<int, std::uint16_t> shared_place; // of a lane
  b.first_shared = static_cast<int>(shared_lane.size());
  const auto local = [&](int of_sheet) {
    const std::uint16_t slot = slots.local(b.points, of_sheet);
    if (b.runs == 0) return slot;
    const std::uint16_t its_lane = lane[static_cast<std::size_t>(b.points.first) + slot];
    const auto [at, is_new] = shared_place.try_emplace(its_lane, static_cast<std::uint16_t>(shared_place.size()));
    if (is_new) shared_lane.push_back(its_lane);
    return at->second;
  };
  for (std::size_t n = 0; n < patches.size(); ++n) {
    if (is_placed[n] != 0) continue;
    const CurvaturePatch& patch = patches[n];
    node.push_back(laid.first_node + static_cast<int>(n));
    std::transform(patch.points.begin(), patch.points.end(), std::back_inserter(point), local);
    first.push_back(static_cast<int>(point.size()));
    weights_of.push_back(shared.place(patch));
    const auto& [a0, a1, b0, b1] = patch.ends;
    ends.push_back({local(a0), local(a1), local(b0), local(b1)});
  }
  b.shared = static_cast<int>(shared_place.size());
  b.singles = static_cast<int>(ends.size()) - b.first_single;
  b.places = static_cast<int>(node.size()) - b.first_place;
  blocks.push_back(b);
}

std::vector<int> CurvatureOperator::points_by_lane(const Block& block) const
{
  const std::span<const int> points = slots.points(block.points);
  std::vector<int> of_lane(static_cast<std::size_t>(block.lanes), -1);
  if (block.runs == 0) return of_lane;
  for (std::size_t i = 0; i < points.size(); ++i) of_lane[lane[static_cast<std::size_t>(block.points.first) + i]] = points[i];
  return of_lane;
}

void CurvatureOperator::fill(Patch& patch, const Run& run, int number, std::span<const int> point_of_lane) const
{
  const auto at = [&](int lanes) { return point_of_lane[static_cast<std::size_t>(run.first_lane + number + lanes)]; };
  patch.point_.clear();
  patch.weight_.clear();
  const YarnPair change = run.change_terms > 0 ? times[run.first_time + number] : YarnPair{};
  for (int i = run.first_point; i < run.first_point + run.points; ++i) {
    const StencilPoint& p = run_point[i];
    patch.point_.push_back(at(p.ahead));
    patch.weight_.push_back({p.warp + change.warp * p.change, p.weft + change.weft * p.change});
  }
  std::transform(run.ends.begin(), run.ends.end(), patch.ends.begin(), at);
}

void CurvatureOperator::fill(Patch& patch, const Block& block, int single, std::span<const int> point_of_lane) const
{
  const std::span<const int> points = slots.points(block.points);
  const auto at = [&](int its) { return block.runs == 0 ? points[its] : point_of_lane[shared_lane[block.first_shared + its]]; };
  const int n = block.first_single + single;
  patch.point_.clear();
  for (int t = first[n]; t < first[n + 1]; ++t) patch.point_.push_back(at(point[t]));
  const auto its = weight.begin() + weights_of[n];
  patch.weight_.assign(its, its + (first[n + 1] - first[n]));
  std::transform(ends[n].begin(), ends[n].end(), patch.ends.begin(), at);
}

bool CurvatureOperator::complete() const
{
  for (std::size_t n = 0; n + 1 < first.size(); ++n)
    if (first[n] == first[n + 1]) return false;
  return true;
}

std::vector<YarnPair> CurvatureOperator::at(std::span<const Vec3> position) const
{
  std::vector<Vec3> image;
  for (const MirrorImage& i : images) image.push_back(i.position(position));
  const ImagedPositions x(position, image);
  std::vector<YarnPair> curvature(nodes());
  parallel_each(static_cast<int>(blocks.size()), [&](int number) {
    each_node(blocks[number], [&](int place, const Patch& patch) {
      Vec3 warp, weft;
      patch.each_term([&](int its_point, const YarnPair& share) {
        warp += share.warp * x[its_point];
        weft += share.weft * x[its_point];
      });
      const auto& [a0, a1, b0, b1] = patch.ends;
      const Vec3 normal = normalized(cross(x[a1] - x[a0], x[b1] - x[b0]));
      curvature[node[place]] = {dot(normal, warp), dot(normal, weft)};
    });
  });
  return curvature;
}

} // namespace towform
