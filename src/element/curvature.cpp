#include "element/curvature.hpp"
#include "element/moment_balance.hpp"
#include "mesh/outline.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <iterator>
#include <limits>
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

/// Two chords of a node's ring that pass as nearly through the node as can be and are not too nearly
/// parallel; of equally good ones those along and across the warp, so that a regular mesh is treated
/// regularly.
std::array<int, 4> chords_of(const MirroredSheet& sheet, int node, const Vec3& warp)
{
  std::vector<int> ends = sheet.neighbours[node];
  ends.push_back(node);
  struct Chord {
    int from, to;
    double off; ///< distance of the middle from the node, over half the length
    Vec3 along; ///< unit
  };
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 from = sheet.points[ends[i]] - sheet.points[node],
                 to = sheet.points[ends[j]] - sheet.points[node];
      const double length = norm(to - from);
      chords.push_back({ends[i], ends[j], norm(from + to) / length, (1.0 / length) * (to - from)});
    }
  const auto best = [&](const auto& angle) { // the nearest, then that of the largest sine or cosine
    constexpr double rounding = 1e-6;
    const Chord* found = nullptr;
    for (const Chord& c : chords) {
      constexpr double least = 0.5;
      if (angle(c) < least) continue;
      const auto is_better = [&](const Chord& than) {
        const double nearer = than.off - c.off;
        return nearer > rounding || (nearer > -rounding && angle(c) > angle(than) + rounding);
      };
      if (found == nullptr || is_better(*found)) found = &c;
    }
    return found;
  };
  const auto cosine = [&](const Chord& c) { return std::abs(dot(c.along, warp)); };
  const Chord* first = best(cosine);
  if (first == nullptr) first = &chords.front();
  const auto sine = [&](const Chord& c) { return std::abs(cross(first->along, c.along).z); };
  const Chord* second = best(sine);
  if (second == nullptr) // the tip of a sliver
    second = &*std::max_element(chords.begin(), chords.end(),
                                [&](const Chord& c, const Chord& d) { return sine(c) < sine(d); });
  if (cross(first->along, second->along).z > 0.0) return {first->from, first->to, second->from, second->to};
  return {first->from, first->to, second->to, second->from};
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

} // namespace

/// What a node's curvatures are made of, by points of the whole sheet. Terms are in an order that depends on the weights alone.
struct CurvatureOperator::Patch {
  std::vector<int> points;
  std::vector<YarnPair> weights;
  std::vector<std::int64_t> key; ///< the weights but for rounding
  std::array<int, 4> ends;

  Patch() = default;
  Patch(const std::vector<int>& its_points, const std::vector<double>& warp, const std::vector<double>& weft,
        const std::array<int, 4>& its_ends)
      : ends(its_ends)
  {
    constexpr double rounding = 1e-11; // of the largest weight
    double largest = 0.0;
    for (const auto* weights_of_one : {&warp, &weft})
      for (const double w : *weights_of_one) largest = std::max(largest, std::abs(w));
    struct Term {
      std::int64_t warp, weft;
      std::size_t place;
      auto operator<=>(const Term&) const = default;
    };
    const auto whole = [&](double w) { return std::llround(w / (rounding * largest)); };
    std::vector<Term> terms;
    for (std::size_t i = 0; i < its_points.size(); ++i) terms.push_back({whole(warp[i]), whole(weft[i]), i});
    std::sort(terms.begin(), terms.end());
    for (const Term& term : terms) {
      points.push_back(its_points[term.place]);
      weights.push_back({warp[term.place], weft[term.place]});
      key.insert(key.end(), {term.warp, term.weft});
    }
  }
};

/// Finds weights that are there already.
class CurvatureOperator::SharedWeights {
public:
  explicit SharedWeights(std::vector<YarnPair>& all) : all_(all) {}

  /// Where a patch's weights begin.
  int place(const Patch& patch)
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
  if (balance > 0 && fitted)
    for (std::size_t d = 0; d < 2; ++d)
      imbalance = std::max(imbalance,
                           balance_moments(sheet, blank.mesh, fits, area, directions[d], balance, weights[d]));
  // Some blocks at a time: all patches together would be what a fine mesh takes most memory for.
  constexpr std::size_t together = 64 * block_size;
  SharedWeights shared(weight);
  first.push_back(0);
  std::vector<Patch> patches;
  for (std::size_t begin = 0; begin < sheet.nodes; begin += together) {
    patches.resize(std::min(together, sheet.nodes - begin));
    parallel_each(static_cast<int>(patches.size()), [&](int i) {
      const std::size_t n = begin + static_cast<std::size_t>(i);
      patches[i] = Patch(std::exchange(fits[n].points, {}), std::exchange(weights[0][n], {}), std::exchange(weights[1][n], {}),
                         chords[n]);
    });
    for (std::size_t i = 0; i < patches.size(); i += block_size)
      add_block(std::span(patches).subspan(i, std::min<std::size_t>(block_size, patches.size() - i)));
    for (const Patch& patch : patches) weights_of.push_back(shared.place(patch));
  }
  slots.finish(sheet.nodes); // images hand theirs on
  point.shrink_to_fit();
  weight.shrink_to_fit();
}

void CurvatureOperator::add_block(std::span<const Patch> patches)
{
  std::vector<int> reached;
  for (const Patch& patch : patches) {
    reached.insert(reached.end(), patch.points.begin(), patch.points.end());
    reached.insert(reached.end(), patch.ends.begin(), patch.ends.end());
  }
  const BlockSlots::Range range = slots.add(std::move(reached));
  blocks.push_back({static_cast<int>(ends.size()), static_cast<int>(patches.size()), range});
  const auto local = [&](int of_sheet) { return slots.local(range, of_sheet); };
  for (const Patch& patch : patches) {
    std::transform(patch.points.begin(), patch.points.end(), std::back_inserter(point), local);
    first.push_back(static_cast<int>(point.size()));
    const auto& [a0, a1, b0, b1] = patch.ends;
    ends.push_back({local(a0), local(a1), local(b0), local(b1)});
  }
}

bool CurvatureOperator::complete() const
{
  for (std::size_t n = 0; n < nodes(); ++n)
    if (first[n] == first[n + 1]) return false;
  return true;
}

std::vector<YarnPair> CurvatureOperator::at(std::span<const Vec3> position) const
{
  std::vector<Vec3> image;
  for (const MirrorImage& i : images) image.push_back(i.position(position));
  const ImagedPositions x(position, image);
  std::vector<YarnPair> curvature(nodes());
  parallel_ranges(static_cast<std::ptrdiff_t>(nodes()), [&](auto begin, auto end) {
    for (auto n = begin; n < end; ++n) {
      Vec3 warp, weft;
      each_term(static_cast<std::size_t>(n), [&](int of_sheet, const YarnPair& share) {
        warp += share.warp * x[of_sheet];
        weft += share.weft * x[of_sheet];
      });
      const std::span<const int> points = slots.points(blocks[static_cast<std::size_t>(n) / block_size].points);
      const auto end_of = [&](std::size_t k) { return x[points[ends[n][k]]]; };
      const Vec3 normal = normalized(cross(end_of(1) - end_of(0), end_of(3) - end_of(2)));
      curvature[n] = {dot(normal, warp), dot(normal, weft)};
    }
  });
  return curvature;
}

} // namespace towform
