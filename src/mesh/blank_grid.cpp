#include "mesh/blank_grid.hpp"
#include <algorithm>
#include <cmath>

namespace towform {
namespace {

int nearest_even(double cells) { return 2 * std::max(1, static_cast<int>(std::lround(0.5 * cells))); }

/// Smaller is better: the tier first (count within 1 % and cells nearly square, or tolerably so), then the
/// sum of squares of both errors over what is allowed.
std::pair<int, double> misfit(Vec2 size, GridCounts c, double cells)
{
  const double count = std::abs(static_cast<double>(c.x) * c.y / cells - 1.0) / 0.01;
  const double aspect = std::abs(std::log((size.x / c.x) / (size.y / c.y)));
  const double square = aspect / std::log(1.03);
  const int tier = count <= 1.0 && square <= 1.0 ? 0 : count <= 1.0 && aspect <= std::log(1.1) ? 1 : 2;
  return {tier, count + square};
}

/// Grid points along one direction, from the centre or over the whole length: size i / cells, odd in i.
struct Line {
  double size;
  int cells, first;

  [[nodiscard]] int last() const { return cells / 2; }
  [[nodiscard]] int points() const { return last() - first + 1; }
  [[nodiscard]] double at(int i) const
  {
    const int half = cells / 2;
    if (std::abs(i) == half) return i < 0 ? -0.5 * size : 0.5 * size; // no rounding of the sides
    return 0.5 * size * i / half;
  }
};

class Grid {
public:
  Grid(Line x, Line y) : x_(x), y_(y) {}

  SurfaceMesh mesh(Pattern pattern)
  {
    for (int j = y_.first; j <= y_.last(); ++j) {
      for (int i = x_.first; i <= x_.last(); ++i) mesh_.points.push_back({x_.at(i), y_.at(j), 0.0});
    }
    for (int j = y_.first; j < y_.last(); ++j) {
      for (int i = x_.first; i < x_.last(); ++i) {
        if (pattern == Pattern::cross) {
          cut_crosswise(i, j);
        } else {
          cut_in_two(i, j);
        }
      }
    }
    return std::move(mesh_);
  }

private:
  [[nodiscard]] int point(int i, int j) const { return (j - y_.first) * x_.points() + i - x_.first; }

  void cut_in_two(int i, int j)
  {
    const int a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
    if (rising_diagonal(i, j)) {
      mesh_.triangles.insert(mesh_.triangles.end(), {{a, b, c}, {a, c, d}});
    } else {
      mesh_.triangles.insert(mesh_.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  }

  void cut_crosswise(int i, int j)
  {
    const int a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
    const int centre = static_cast<int>(mesh_.points.size());
    mesh_.points.push_back({0.5 * (x_.at(i) + x_.at(i + 1)), 0.5 * (y_.at(j) + y_.at(j + 1)), 0.0});
    mesh_.triangles.insert(mesh_.triangles.end(),
                           {{a, b, centre}, {b, c, centre}, {c, d, centre}, {d, a, centre}});
  }

  Line x_, y_;
  SurfaceMesh mesh_;
};

} // namespace

int triangles_per_cell(Pattern pattern) { return pattern == Pattern::cross ? 4 : 2; }

GridCounts grid_for_elements(Vec2 size, int elements, Pattern pattern)
{
  const double cells = static_cast<double>(elements) / triangles_per_cell(pattern);
  const bool wide = size.x >= size.y;
  // Candidates: every even number of cells near the ideal one on the short side, and its two best partners.
  const double ideal = std::sqrt(cells * (wide ? size.y / size.x : size.x / size.y));
  GridCounts best;
  auto least = misfit(size, best, cells);
  for (int across = nearest_even(0.8 * ideal); across <= nearest_even(1.25 * ideal); across += 2) {
    const int along = std::max(2, 2 * static_cast<int>(0.5 * cells / across));
    for (const int candidate : {along, along + 2}) {
      const GridCounts c = wide ? GridCounts{candidate, across} : GridCounts{across, candidate};
      if (const auto m = misfit(size, c, cells); m < least) {
        least = m;
        best = c;
      }
    }
  }
  return best;
}

GridCounts grid_for_edge(Vec2 size, double edge)
{
  return {nearest_even(size.x / edge), nearest_even(size.y / edge)};
}

SurfaceMesh aligned_grid(Vec2 size, GridCounts counts, Pattern pattern, Symmetry symmetry)
{
  const bool half_x = symmetry == Symmetry::x || symmetry == Symmetry::quarter;
  const bool half_y = symmetry == Symmetry::y || symmetry == Symmetry::quarter;
  return Grid({size.x, counts.x, half_x ? 0 : -counts.x / 2}, {size.y, counts.y, half_y ? 0 : -counts.y / 2})
      .mesh(pattern);
}

} // namespace towform
