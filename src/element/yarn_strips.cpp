#include "element/yarn_strips.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace towform {

namespace {

/// A rectangle of the lattice of one yarn family: row across, column along the yarns, level by element size.
struct Cell {
  int level, family, row, column;
  auto operator<=>(const Cell&) const = default; // NOLINT(modernize-use-nullptr): none is used
};

/// Index of the interval of a lattice that has a border at 0, alike on both sides of it.
int interval(double x)
{
  constexpr double nudge = 1e-6; // what lies on a border goes outwards, whatever the rounding
  const int k = static_cast<int>(std::floor(std::abs(x) + nudge));
  return x >= 0.0 ? k : -1 - k;
}

/// Index of the interval of a lattice that is centred on 0.
int centred_interval(double x)
{
  constexpr double nudge = 1e-6;
  const int k = static_cast<int>(std::floor(std::abs(x) + 0.5 + nudge));
  return x >= 0.0 ? k : -k;
}

bool is_shifted(int row) { return (row >= 0 ? row : -1 - row) % 2 == 1; }

/// The lattice of strips on the flat blank.
class Lattice {
public:
  Lattice(const Blank& blank, double edge)
      : edge_(edge), length_(follows_yarns(blank) ? YarnStrips::aligned_length : YarnStrips::strip_length)
  {
    const Vec3 normal{0.0, 0.0, 1.0};
    along_[0] = blank.warp;
    along_[1] = blank.weft;
    for (int f = 0; f < 2; ++f) across_[f] = cross(normal, along_[f]);
    if (!blank.mirror_x.empty()) mirrors_.push_back({1, 0, 0});
    if (!blank.mirror_y.empty()) mirrors_.push_back({0, 1, 0});
  }

  [[nodiscard]] int level(double edge) const
  {
    return static_cast<int>(std::lround(std::log2(edge / edge_)));
  }

  struct Place {
    Cell cell;
    int times; ///< how often an entry there counts: its mirror images in the same cell, and itself
  };

  /// The cell of a point, or the one of its mirror images that comes first.
  [[nodiscard]] Place place(const Vec3& point, int family, int level) const
  {
    const Cell own = here(point, family, level);
    Place p{own, 1};
    const auto see = [&](const Cell& image) {
      p.cell = std::min(p.cell, image);
      p.times += image == own;
    };
    for (const Vec3& a : mirrors_) see(image(point, family, level, a));
    if (mirrors_.size() == 2)
      see(image(reflected(point, mirrors_[1]), exchanged(family, mirrors_[1]), level, mirrors_[0]));
    return p;
  }

private:
  [[nodiscard]] Cell here(const Vec3& point, int family, int level) const
  {
    const double edge = std::ldexp(edge_, level);
    const int row = interval(dot(point, across_[family]) / (YarnStrips::strip_width * edge));
    const double along = dot(point, along_[family]) / (length_ * edge);
    return {level, family, row, is_shifted(row) ? centred_interval(along) : interval(along)};
  }

  static Vec3 reflected(const Vec3& p, const Vec3& mirror) { return p - (2.0 * dot(p, mirror)) * mirror; }

  /// The family that a reflected yarn belongs to.
  [[nodiscard]] int exchanged(int family, const Vec3& mirror) const
  {
    const Vec3 yarn = reflected(along_[family], mirror);
    return std::abs(dot(yarn, along_[family])) >= std::abs(dot(yarn, along_[1 - family])) ? family
                                                                                          : 1 - family;
  }

  [[nodiscard]] Cell image(const Vec3& point, int family, int level, const Vec3& mirror) const
  {
    return here(reflected(point, mirror), exchanged(family, mirror), level);
  }

  double edge_, length_; // the length in edges
  Vec3 along_[2], across_[2];
  std::vector<Vec3> mirrors_;
};

struct Content {
  std::vector<YarnEntry> entries;
  int count = 0; ///< of the entries of the whole sheet
};
using Cells = std::map<Cell, Content>;

/// The smaller neighbour along the row, the inner one of two equals.
Cells::iterator neighbour(Cells& cells, const Cell& cell)
{
  auto best = cells.end();
  for (const int step : {-1, 1}) {
    const auto other = cells.find({cell.level, cell.family, cell.row, cell.column + step});
    if (other == cells.end()) continue;
    const auto rank = [](Cells::iterator c) {
      return std::tuple(c->second.count, std::abs(2 * c->first.column + 1));
    };
    if (best == cells.end() || rank(other) < rank(best)) best = other;
  }
  return best;
}

/// Cells with too few entries join a neighbour; one that is alone in its row stays as it is.
void join_small(Cells& cells)
{
  for (auto cell = cells.begin(); cell != cells.end();) {
    const bool small = cell->second.count < YarnStrips::fewest_entries;
    const auto other = small ? neighbour(cells, cell->first) : cells.end();
    if (other == cells.end()) {
      ++cell;
      continue;
    }
    std::vector<YarnEntry>& entries = other->second.entries;
    entries.insert(entries.end(), cell->second.entries.begin(), cell->second.entries.end());
    other->second.count += cell->second.count;
    cell = cells.erase(cell);
  }
}

/// Edge of a right-angled triangle of the mean area of the elements round an element, itself among them: a
/// sliver has the size of its surroundings.
std::vector<double> local_edges(const Blank& blank, std::span<const double> area)
{
  const std::size_t nodes = blank.mesh.points.size();
  std::vector<double> sum(nodes, 0.0), count(nodes, 0.0), edge;
  for (std::size_t e = 0; e < area.size(); ++e)
    for (const int n : blank.mesh.triangles[e]) {
      sum[n] += area[e];
      ++count[n];
    }
  for (const auto& [a, b, c] : blank.mesh.triangles)
    edge.push_back(std::sqrt(2.0 * (sum[a] + sum[b] + sum[c]) / (count[a] + count[b] + count[c])));
  return edge;
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

YarnStrips collected(const std::vector<std::vector<YarnEntry>>& lists, std::span<const double> area)
{
  YarnStrips s;
  s.of.resize(2 * area.size());
  s.first.push_back(0);
  for (const std::vector<YarnEntry>& list : lists) {
    double sum = 0.0;
    for (const YarnEntry i : list) {
      s.of[i] = static_cast<int>(s.area.size());
      s.entry.push_back(i);
      sum += area[i / 2];
    }
    s.area.push_back(sum);
    s.first.push_back(static_cast<int>(s.entry.size()));
  }
  return s;
}

} // namespace

void YarnStrips::find_entries()
{
  std::vector<int> next(first.begin(), first.end() - 1);
  entry.resize(of.size());
  for (std::size_t i = 0; i < of.size(); ++i) entry[static_cast<std::size_t>(next[of[i]]++)] = static_cast<YarnEntry>(i);
}

void YarnStrips::reorder(std::span<const int> order)
{
  YarnStrips its;
  its.of.resize(of.size());
  its.entry.reserve(entry.size());
  its.first.push_back(0);
  for (const int strip : order) {
    for (const YarnEntry of_strip : entries_of(static_cast<std::size_t>(strip))) {
      its.of[of_strip] = static_cast<int>(its.area.size());
      its.entry.push_back(of_strip);
    }
    its.area.push_back(area[strip]);
    its.first.push_back(static_cast<int>(its.entry.size()));
  }
  *this = std::move(its);
}

bool follows_yarns(const Blank& blank)
{
  constexpr double tolerance = 1e-6; // sine of the angle between edge and yarn
  const auto has_edge_along = [&](const Triangle& t, const Vec3& yarn) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = blank.mesh.points[t[(k + 1) % 3]] - blank.mesh.points[t[k]];
      if (norm(cross(edge, yarn)) < tolerance * norm(edge)) return true;
    }
    return false;
  };
  return std::all_of(blank.mesh.triangles.begin(), blank.mesh.triangles.end(), [&](const Triangle& t) {
    return has_edge_along(t, blank.warp) && has_edge_along(t, blank.weft);
  });
}

YarnStrips lay_strips(const Blank& blank, std::span<const double> area)
{
  const std::vector<double> edge = local_edges(blank, area);
  const Lattice lattice(blank, median(edge));
  Cells cells;
  for (std::size_t e = 0; e < area.size(); ++e) {
    const auto& [a, b, c] = blank.mesh.triangles[e];
    const Vec3 centre = (1.0 / 3.0) * (blank.mesh.points[a] + blank.mesh.points[b] + blank.mesh.points[c]);
    for (int family = 0; family < 2; ++family) {
      const auto [cell, times] = lattice.place(centre, family, lattice.level(edge[e]));
      Content& content = cells[cell];
      content.entries.push_back(static_cast<YarnEntry>(2 * e) + family);
      content.count += times;
    }
  }
  join_small(cells);
  std::vector<std::vector<YarnEntry>> lists;
  for (auto& [cell, content] : cells) {
    std::sort(content.entries.begin(), content.entries.end());
    lists.push_back(std::move(content.entries));
  }
  // In the order of their first elements, which are numbered for locality.
  std::sort(lists.begin(), lists.end());
  return collected(lists, area);
}

YarnStrips strips_of_one(std::span<const double> area)
{
  std::vector<std::vector<YarnEntry>> lists;
  for (std::size_t i = 0; i < 2 * area.size(); ++i) lists.push_back({static_cast<YarnEntry>(i)});
  return collected(lists, area);
}

} // namespace towform
