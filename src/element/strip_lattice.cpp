#include "element/strip_lattice.hpp"
#include "element/yarn_strips.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace towform {

namespace {

constexpr double nudge = 1e-6; // what lies on a border goes outwards, whatever the rounding

/// Index of the interval of a lattice that has a border at 0, alike on both sides of it.
int interval(double x)
{
  const int k = static_cast<int>(std::floor(std::abs(x) + nudge));
  return x >= 0.0 ? k : -1 - k;
}

/// Index of the interval of a lattice that is centred on 0.
int centred_interval(double x)
{
  const int k = static_cast<int>(std::floor(std::abs(x) + 0.5 + nudge));
  return x >= 0.0 ? k : -k;
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Which of the equal strips that a row is divided into an edge has, its middle `x` from the row's in lengths of a strip; what lies
/// on a border goes inwards. Shifted strips are one fewer: those at the row's ends are half as long again, as shorter ones there
/// would limit the step.
int strip_in_row(double x, int strips, bool shifted)
{
  if (strips == 1) return 0;
  const int count = shifted ? strips - 1 : strips, last = (count - 1) / 2;
  const bool centred = count % 2 == 1;
  const int k = std::clamp(static_cast<int>(std::ceil(std::abs(x) - (centred ? 0.5 : 1.0) - nudge)), 0, last);
  return x >= -nudge ? k : centred ? -k : -1 - k;
}

Vec3 reflected(const Vec3& p, const Vec3& mirror) { return p - (2.0 * dot(p, mirror)) * mirror; }

std::array<Vec3, 3> reflected(const std::array<Vec3, 3>& corners, const Vec3& mirror)
{
  return {reflected(corners[0], mirror), reflected(corners[1], mirror), reflected(corners[2], mirror)};
}

std::array<double, 3> along(const std::array<Vec3, 3>& corners, const Vec3& way)
{
  return {dot(corners[0], way), dot(corners[1], way), dot(corners[2], way)};
}

Vec3 centre(const std::array<Vec3, 3>& corners) { return (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]); }

} // namespace

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

StripLattice::StripLattice(const Blank& blank, std::span<const double> edge)
    : blank_(blank), edge_(median({edge.begin(), edge.end()})), aligned_(follows_yarns(blank)), along_{blank.warp, blank.weft}
{
  for (const double its : edge) level_.push_back(level(its));
  const Vec3 normal{0.0, 0.0, 1.0};
  for (std::size_t f = 0; f < 2; ++f) across_[f] = cross(normal, along_[f]);
  if (!blank.mirror_x.empty()) mirrors_.push_back({1, 0, 0});
  if (!blank.mirror_y.empty()) mirrors_.push_back({0, 1, 0});
  if (aligned_) measure_rows();
}

StripLattice::Corners StripLattice::corners(std::size_t element) const
{
  const auto& [a, b, c] = blank_.mesh.triangles[element];
  return {blank_.mesh.points[a], blank_.mesh.points[b], blank_.mesh.points[c]};
}

int StripLattice::level(double edge) const { return static_cast<int>(std::lround(std::log2(edge / edge_))); }

/// The family that a reflected yarn belongs to.
int StripLattice::exchanged(int family, const Vec3& mirror) const
{
  const Vec3 yarn = reflected(along_[family], mirror);
  return std::abs(dot(yarn, along_[family])) >= std::abs(dot(yarn, along_[1 - family])) ? family : 1 - family;
}

/// visit(corners, family) for an element and its mirror images.
template <class Visit>
void StripLattice::each_image(const Corners& corners, int family, const Visit& visit) const
{
  visit(corners, family);
  for (const Vec3& mirror : mirrors_) visit(reflected(corners, mirror), exchanged(family, mirror));
  if (mirrors_.size() < 2) return;
  visit(reflected(reflected(corners, mirrors_[1]), mirrors_[0]), exchanged(exchanged(family, mirrors_[1]), mirrors_[0]));
}

/// The row of a triangle that has an edge along the yarn. Lines are counted in halves, as the middle of the blank may lie between
/// two.
StripLattice::Row StripLattice::row(const Corners& corners, int family, int level) const
{
  const std::array<double, 3> across = along(corners, across_[family]);
  std::size_t tip = 0; // the corner off the line
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(across[(k + 1) % 3] - across[(k + 2) % 3]) < std::abs(across[(tip + 1) % 3] - across[(tip + 2) % 3])) tip = k;
  const double line = 0.5 * (across[(tip + 1) % 3] + across[(tip + 2) % 3]);
  const int half_lines = static_cast<int>(std::lround(2.0 * line / std::ldexp(line_[family], level)));
  const bool beyond = across[tip] > line;
  const double middle = 0.5 * dot(corners[(tip + 1) % 3] + corners[(tip + 2) % 3], along_[family]);
  return {2 * half_lines + (beyond ? 1 : 0), middle, half_lines != 0 && beyond != (half_lines > 0), half_lines == 0};
}

void StripLattice::measure_rows()
{
  for (std::size_t f = 0; f < 2; ++f) {
    std::vector<double> lengths, widths;
    for (std::size_t e = 0; e < level_.size(); ++e)
      for (const auto& [way, extents] : {std::pair{along_[f], &lengths}, std::pair{across_[f], &widths}}) {
        const std::array<double, 3> its = along(corners(e), way);
        extents->push_back(*std::max_element(its.begin(), its.end()) - *std::min_element(its.begin(), its.end()));
      }
    element_[f] = median(std::move(lengths));
    line_[f] = median(std::move(widths));
  }
  for (std::size_t e = 0; e < level_.size(); ++e)
    for (int family = 0; family < 2; ++family)
      each_image(corners(e), family, [&](const Corners& image, int its) {
        const std::array<double, 3> x = along(image, along_[its]);
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        const auto [at, is_new] = ends_.try_emplace({level_[e], its, row(image, its, level_[e]).number}, Ends{*low, *high});
        at->second = {std::min(at->second.low, *low), std::max(at->second.high, *high)};
      });
}

StripCell StripLattice::cell_of_row(const Corners& corners, int family, int level) const
{
  const Row its = row(corners, family, level);
  const auto& [low, high] = ends_.at({level, family, its.number});
  const double elements = (high - low) / std::ldexp(element_[family], level);
  const double wanted = (its.on_middle ? 2.0 : 1.0) * YarnStrips::aligned_elements;
  const int strips = std::max(1, static_cast<int>(std::floor(elements / wanted + nudge)));
  const double x = (its.middle - 0.5 * (low + high)) * strips / (high - low);
  return {level, family, its.number, strip_in_row(x, strips, its.shifted)};
}

StripCell StripLattice::cell(const Corners& corners, int family, int level) const
{
  if (aligned_) return cell_of_row(corners, family, level);
  const double edge = std::ldexp(edge_, level);
  const Vec3 point = centre(corners);
  const int row = interval(dot(point, across_[family]) / (YarnStrips::strip_width * edge));
  const double x = dot(point, along_[family]) / (YarnStrips::strip_length * edge);
  const bool shifted = (row >= 0 ? row : -1 - row) % 2 == 1;
  return {level, family, row, shifted ? centred_interval(x) : interval(x)};
}

StripLattice::Place StripLattice::place(std::size_t element, int family) const
{
  const StripCell own = cell(corners(element), family, level_[element]);
  Place place{own, 0};
  each_image(corners(element), family, [&](const Corners& image, int its) {
    const StripCell cell_of_image = cell(image, its, level_[element]);
    place.cell = std::min(place.cell, cell_of_image);
    place.times += cell_of_image == own ? 1 : 0;
  });
  return place;
}

} // namespace towform
