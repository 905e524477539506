#include "element/yarn_strips.hpp"
#include "element/strip_lattice.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace towform {

namespace {

struct Content {
  std::vector<YarnEntry> entries;
  int count = 0; ///< of the entries of the whole sheet
};
using Cells = std::map<StripCell, Content>;

/// The smaller neighbour along the row, the inner one of two equals.
Cells::iterator neighbour(Cells& cells, const StripCell& cell)
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

YarnStrips lay_strips(const Blank& blank, std::span<const double> area)
{
  const StripLattice lattice(blank, local_edges(blank, area));
  Cells cells;
  for (std::size_t e = 0; e < area.size(); ++e) {
    for (int family = 0; family < 2; ++family) {
      const auto [cell, times] = lattice.place(e, family);
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
