#include "solver/placement.hpp"
#include "mesh/box.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

constexpr double rounding = 1e-7; // [m]: STL files hold single precision

double widest(const Box& box)
{
  const Vec3 size = box.high - box.low;
  return std::max({size.x, size.y, size.z});
}

bool apart(const Box& a, const Box& b)
{
  return a.low.x > b.high.x || b.low.x > a.high.x || a.low.y > b.high.y || b.low.y > a.high.y ||
         a.low.z > b.high.z || b.low.z > a.high.z;
}

/// Smallest and largest displacement along the tool's direction during the run; a force may push it anywhere.
std::pair<double, double> travel(const Tool& tool, double end)
{
  if (tool.force) return {-1e3, 1e3};
  std::pair<double, double> range{0.0, 0.0};
  if (!tool.motion) return range;
  constexpr int samples = 1000;
  for (int i = 0; i <= samples; ++i) {
    const double d = tool.motion->displacement(end * i / samples);
    range = {std::min(range.first, d), std::max(range.second, d)};
  }
  return range;
}

struct Deepest {
  int node = -1;
  double depth = rounding;
};

/// Deepest node of the blank inside the tool, or -1.
Deepest deepest(const std::vector<Vec3>& sheet, double thickness, const Tool& tool)
{
  constexpr std::size_t block = 1024;
  std::vector<Deepest> of_block((sheet.size() + block - 1) / block);
  parallel_each(static_cast<int>(of_block.size()), [&](int number) {
    Deepest& here = of_block[static_cast<std::size_t>(number)];
    const std::size_t first = block * static_cast<std::size_t>(number);
    SurfacePoint nearest;
    Vec3 middle; // of a ball that the tool is clear of
    double clear = 0.0;
    for (std::size_t n = first; n < std::min(first + block, sheet.size()); ++n) {
      if (norm(sheet[n] - middle) < clear) continue;
      nearest = tool.surface.nearest(sheet[n], nearest.facet);
      middle = sheet[n];
      clear = nearest.distance - 0.5 * thickness;
      const double overlap = -clear;
      if (overlap > here.depth && !(nearest.distance < 0.0 && nearest.on_border))
        here = {static_cast<int>(n), overlap};
    }
  });
  Deepest all;
  for (const Deepest& here : of_block)
    if (here.node >= 0 && here.depth > all.depth) all = here;
  return all;
}

} // namespace

void check_placement(const Case& c, const Blank& blank, const std::vector<Tool>& tools,
                     std::vector<InputIssue>& issues)
{
  const std::vector<Vec3> nodes = blank.start_positions();
  Box sheet = box_of(nodes);
  const double blank_width = widest(sheet);
  // A drawn sheet follows the tools: anything within a blank's width of its plane can be met.
  sheet.low.z -= blank_width;
  sheet.high.z += blank_width;

  for (std::size_t i = 0; i < tools.size(); ++i) {
    const Tool& tool = tools[i];
    const std::string key = fmt::format("tool[{}].mesh", i);
    const Box body{tool.surface.lowest(), tool.surface.highest()};
    const double ratio = widest(body) / blank_width;
    if (ratio > 50.0 || ratio < 0.02) {
      issues.push_back(
          {c.where(key),
           fmt::format("tool '{}' is {:.4g} m wide against a blank of {:.4g} m: an STL file carries no "
                       "unit, {} right?",
                       tool.name, widest(body), blank_width,
                       c.blank.mesh.empty() ? fmt::format("is mesh_unit = {}", c.tools[i].mesh_unit)
                                            : fmt::format("are its mesh_unit = {} and blank.mesh_unit = {}",
                                                          c.tools[i].mesh_unit, c.blank.mesh_unit))});
      continue;
    }
    const auto [low, high] = travel(tool, c.time.end);
    Box swept = body;
    const Vec3 down = low * tool.direction, up = high * tool.direction;
    swept.low += Vec3{std::min(down.x, up.x), std::min(down.y, up.y), std::min(down.z, up.z)};
    swept.high += Vec3{std::max(down.x, up.x), std::max(down.y, up.y), std::max(down.z, up.z)};
    if (apart(swept, sheet)) {
      issues.push_back(
          {c.where(key),
           fmt::format("tool '{}' never comes near the blank: it stays within x {:.4g} to {:.4g}, y {:.4g} "
                       "to {:.4g}, z {:.4g} to {:.4g} m; check its position and mesh_unit",
                       tool.name, swept.low.x, swept.high.x, swept.low.y, swept.high.y, swept.low.z,
                       swept.high.z)});
      continue;
    }
    const auto [node, depth] = deepest(nodes, blank.thickness, tool);
    if (node < 0) continue;
    const Vec3& x = blank.mesh.points[node];
    issues.push_back(
        {c.where(key),
         fmt::format("the blank starts {:.3g} mm inside tool '{}' (at x = {:.4g}, y = {:.4g} m; half its "
                     "thickness counts): move the tool with position = [x, y, z]",
                     1e3 * depth, tool.name, x.x, x.y)});
  }
}

} // namespace towform
