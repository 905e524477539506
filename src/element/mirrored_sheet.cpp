#include "element/mirrored_sheet.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace towform {

namespace {

void add_edge(std::vector<std::vector<int>>& neighbours, int a, int b)
{
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    std::vector<int>& list = neighbours[from];
    const auto at = std::lower_bound(list.begin(), list.end(), to);
    if (at == list.end() || *at != to) list.insert(at, to);
  }
}

} // namespace

MirroredSheet::MirroredSheet(const SurfaceMesh& flat, std::span<const SymmetryLine> lines)
    : points(flat.points), neighbours(flat.points.size()), nodes(flat.points.size())
{
  for (const Triangle& t : flat.triangles)
    for (int k = 0; k < 3; ++k) add_edge(neighbours, t[k], t[(k + 1) % 3]);
  for (const SymmetryLine& line : lines)
    if (!line.nodes.empty()) mirror(line);
}

void MirroredSheet::mirror(const SymmetryLine& line)
{
  const bool in_x = line.across == SymmetryLine::Across::x;
  const int on_line = line.nodes.front();
  const auto across = [&](const Vec3& p) { return in_x ? p.x : p.y; };
  const double place = across(points[on_line]);
  double size = 0.0;
  for (const Vec3& p : points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  const auto is_on = [&](int i) { return std::abs(across(points[i]) - place) < 1e-9 * size; };

  // Two rings round the line, of the blank and of what earlier lines have added to it.
  std::vector<int> near;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (is_on(i)) near.push_back(i);
  for (int ring = 0; ring < 2; ++ring) {
    std::vector<int> wider = near;
    for (const int i : near) wider.insert(wider.end(), neighbours[i].begin(), neighbours[i].end());
    std::sort(wider.begin(), wider.end());
    wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
    near = std::move(wider);
  }

  std::map<int, int> image_of;
  for (const int i : near) {
    if (is_on(i)) {
      image_of[i] = i;
      continue;
    }
    MirrorImage image;
    if (static_cast<std::size_t>(i) < nodes)
      image.source = i;
    else
      image = images[static_cast<std::size_t>(i) - nodes];
    int& line_node = in_x ? image.line_x : image.line_y;
    if (line_node >= 0) continue; // behind a parallel line already
    line_node = on_line;
    image_of[i] = static_cast<int>(points.size());
    images.push_back(image);
    Vec3 p = points[i];
    (in_x ? p.x : p.y) = 2.0 * place - across(p);
    points.push_back(p);
  }
  neighbours.resize(points.size());
  for (const auto& [i, image] : image_of) {
    const std::vector<int> of_source = neighbours[i];
    for (const int j : of_source)
      if (const auto other = image_of.find(j); other != image_of.end() && !(is_on(i) && is_on(j)))
        add_edge(neighbours, image, other->second);
  }
}

} // namespace towform
