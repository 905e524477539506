#include "element/mass_lumping.hpp"
#include "element/strip_parts.hpp"
#include <span>

namespace towform {

namespace {

/// Adds the mirror image of a blank; its nodes `on` the mirror are their own images. Nodes keep their numbers.
void unfold(Blank& blank, std::span<const int> on, double Vec3::* across, std::vector<int>& other_mirror)
{
  std::vector<Vec3>& points = blank.mesh.points;
  std::vector<int> image(points.size(), -1);
  for (const int n : on) image[n] = n;
  for (std::size_t n = 0; n < image.size(); ++n) {
    if (image[n] >= 0) continue;
    image[n] = static_cast<int>(points.size());
    points.push_back(points[n]);
    points.back().*across *= -1.0;
  }
  for (std::size_t i = 0, count = other_mirror.size(); i < count; ++i)
    if (const int n = image[other_mirror[i]]; n != other_mirror[i]) other_mirror.push_back(n);
  for (std::size_t e = 0, count = blank.mesh.triangles.size(); e < count; ++e) {
    const auto [a, b, c] = blank.mesh.triangles[e];
    blank.mesh.triangles.push_back({image[a], image[c], image[b]});
  }
}

Blank whole_of(Blank blank)
{
  if (!blank.mirror_x.empty()) unfold(blank, blank.mirror_x, &Vec3::x, blank.mirror_y);
  if (!blank.mirror_y.empty()) unfold(blank, blank.mirror_y, &Vec3::y, blank.mirror_x);
  blank.mirror_x.clear();
  blank.mirror_y.clear();
  return blank;
}

/// A node's surroundings on the flat sheet.
struct NodeSums {
  double stiffness = 0.0; ///< of strips, over that of yarn
  double area = 0.0;      ///< of the elements round it [m^2]
  int elements = 0;

  [[nodiscard]] double third() const { return area / 3.0; }
  [[nodiscard]] double wanted() const { return stiffness * area / elements; }
};

std::vector<NodeSums> sums_of(std::span<const Triangle> triangles, std::span<const double> area, const YarnStrips& strips,
                              const StripParts& parts, std::size_t nodes)
{
  std::vector<NodeSums> sums(nodes);
  for (std::size_t e = 0; e < triangles.size(); ++e)
    for (const int n : triangles[e]) {
      sums[n].area += area[e];
      ++sums[n].elements;
    }
  for (std::size_t i = 0; i < strips.size(); ++i)
    for (const StripParts::Part& p : parts.of(i)) sums[p.component / 2].stiffness += strips.area[i] * p.gradient * p.gradient;
  return sums;
}

std::vector<NodeSums> sums_of_whole(const Blank& blank, bool strips_are_elements)
{
  const Blank whole = whole_of(blank);
  std::vector<YarnGradients> gradients;
  std::vector<double> area;
  for (const Triangle& t : whole.mesh.triangles) {
    const FlatTriangle flat = flat_triangle(whole, t);
    gradients.push_back(flat.gradients);
    area.push_back(flat.area);
  }
  const YarnStrips strips = strips_are_elements ? strips_of_one(area) : lay_strips(whole, area);
  return sums_of(whole.mesh.triangles, area, strips, {whole.mesh.triangles, gradients, area, strips}, whole.mesh.points.size());
}

} // namespace

std::vector<double> lumping_factors(const Blank& blank, const Membrane& membrane, double share)
{
  const bool part = !blank.mirror_x.empty() || !blank.mirror_y.empty();
  const bool strips_are_elements = membrane.strips.size() == 2 * membrane.triangles.size();
  const std::vector<NodeSums> sums =
      part ? sums_of_whole(blank, strips_are_elements)
           : sums_of(membrane.triangles, membrane.areas(), membrane.strips, StripParts(membrane), membrane.node_area.size());
  double thirds = 0.0, wanted = 0.0;
  for (const NodeSums& s : sums) {
    thirds += s.third();
    wanted += s.wanted();
  }
  std::vector<double> factors;
  for (std::size_t n = 0; n < membrane.node_area.size(); ++n)
    factors.push_back(1.0 - share + share * thirds / wanted * sums[n].wanted() / sums[n].third());
  return factors;
}

} // namespace towform
