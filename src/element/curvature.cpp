#include "element/curvature.hpp"
#include "element/moment_balance.hpp"
#include "mesh/outline.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
CurvatureOperator::Chords chords_of(const MirroredSheet& sheet, int node, const Vec3& warp)
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

/// Of the fits' weights none but those of nodes on the outline are wanted any more: a third of what fine meshes take.
void keep_slopes_on_outline(const SurfaceMesh& flat, std::vector<QuadraticFit>& fits)
{
  std::vector<char> is_wanted(fits.size(), 0);
  for (const auto& edge : outline_edges(flat.triangles))
    for (const int n : edge) is_wanted[n] = 1;
  for (std::size_t n = 0; n < fits.size(); ++n)
    if (is_wanted[n] == 0) std::vector<QuadraticFit::Weights>().swap(fits[n].weights);
}

} // namespace

CurvatureOperator::CurvatureOperator(const Blank& blank, std::span<const SymmetryLine> clamped, int balance)
{
  const MirroredSheet sheet(blank.mesh, lines_of(blank, clamped));
  images = sheet.images;
  std::vector<QuadraticFit> fits(sheet.nodes);
  chords.resize(sheet.nodes);
  parallel_ranges(static_cast<std::ptrdiff_t>(sheet.nodes), [&](auto begin, auto end) {
    for (auto n = begin; n < end; ++n) {
      fits[n] = quadratic_fit(sheet, static_cast<int>(n));
      chords[n] = chords_of(sheet, static_cast<int>(n), blank.warp);
    }
  });
  const std::array<Vec3, 2> directions{blank.warp, blank.weft};
  std::array<DirectionalWeights, 2> weights;
  const bool fitted =
      std::all_of(fits.begin(), fits.end(), [](const QuadraticFit& fit) { return !fit.points.empty(); });
  const std::vector<double> area = areas_of(blank.mesh);
  for (std::size_t d = 0; d < 2; ++d) {
    const Vec3& f = directions[d];
    weights[d].reserve(fits.size());
    for (const QuadraticFit& fit : fits) {
      std::vector<double>& of_node = weights[d].emplace_back();
      of_node.reserve(fit.weights.size());
      for (const QuadraticFit::Weights& w : fit.weights)
        of_node.push_back(f.x * f.x * w.xx + 2.0 * f.x * f.y * w.xy + f.y * f.y * w.yy);
    }
  }
  keep_slopes_on_outline(blank.mesh, fits);
  if (balance > 0 && fitted)
    for (std::size_t d = 0; d < 2; ++d)
      imbalance = std::max(imbalance,
                           balance_moments(sheet, blank.mesh, fits, area, directions[d], balance, weights[d]));
  first.reserve(sheet.nodes + 1);
  first.push_back(0);
  for (const QuadraticFit& fit : fits) first.push_back(first.back() + static_cast<int>(fit.points.size()));
  point.reserve(static_cast<std::size_t>(first.back()));
  weight.reserve(point.capacity());
  for (std::size_t n = 0; n < sheet.nodes; ++n)
    for (std::size_t i = 0; i < fits[n].points.size(); ++i) {
      point.push_back(fits[n].points[i]);
      weight.push_back({weights[0][n][i], weights[1][n][i]});
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
      for (int t = first[n]; t < first[n + 1]; ++t) {
        warp += weight[t].warp * x[point[t]];
        weft += weight[t].weft * x[point[t]];
      }
      const Chords& c = chords[n];
      const Vec3 normal = normalized(cross(x[c.a1] - x[c.a0], x[c.b1] - x[c.b0]));
      curvature[n] = {dot(normal, warp), dot(normal, weft)};
    }
  });
  return curvature;
}

} // namespace towform
