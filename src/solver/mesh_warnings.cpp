#include "solver/mesh_warnings.hpp"
#include "element/strip_lattice.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

/// Triangles that cross the yarns lock when a stiff spring ties each to its strip: a mesh whose nodes are a
/// fifth of an edge off the yarns gave a hemisphere's shear 0.7 degrees off with a strip_stiffness of
/// 100, 1.2 with 500 and 2.4 with 1500.
std::string locking(const Case& c, const Model& model)
{
  constexpr double harmless = 200.0;
  const YarnStrips& strips = model.membrane.strips;
  const bool own = strips.size() == strips.of.size(); // every triangle answers to its own strain
  if (own || c.material.strip_stiffness.value_or(0.0) <= harmless || follows_yarns(model.blank)) return "";
  return fmt::format("strip_stiffness locks: {} is for meshes along the yarns, and this one crosses them; "
                     "leave out material.strip_stiffness\n",
                     *c.material.strip_stiffness);
}

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double area = norm(cross(b - a, c - a));
  return std::atan2(area, std::max({dot(b - a, c - a), dot(c - b, a - b), dot(a - c, b - c)}));
}

/// A flat triangle has a coarse strain and a short step, or much mass when that is scaled. A hemisphere's
/// blank whose smallest angle was 22 degrees gave an answer within what halving its edge changed, one with 11
/// did not.
std::string flatness(const Model& model)
{
  constexpr double flat = 15.0; // degrees
  const std::vector<Vec3>& x = model.blank.mesh.points;
  double least = 180.0;
  std::size_t worst = 0, count = 0;
  for (std::size_t e = 0; e < model.membrane.triangles.size(); ++e) {
    const auto& [a, b, c] = model.membrane.triangles[e];
    const double angle = smallest_angle(x[a], x[b], x[c]) * 180.0 / M_PI;
    if (angle < flat) ++count;
    if (angle < least) {
      least = angle;
      worst = e;
    }
  }
  if (count == 0) return "";
  const auto& [a, b, c] = model.membrane.triangles[worst];
  const Vec3 centre = (1.0 / 3.0) * (x[a] + x[b] + x[c]);
  return fmt::format("flat elements: {} of {} have an angle below {} degrees, element {} (x = {:.1f}, y = "
                     "{:.1f} mm) one of {:.2g}; the answer depends on the mesh there\n",
                     count, model.membrane.triangles.size(), flat, worst, 1e3 * centre.x, 1e3 * centre.y,
                     least);
}

} // namespace

std::string mesh_warnings(const Case& c, const Model& model) { return locking(c, model) + flatness(model); }

} // namespace towform
