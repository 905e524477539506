#include "element/quadrilateral_grid.hpp"
#include "mesh/yarn_directions.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace towform {

namespace {

void require(bool fine, const char* message)
{
  if (!fine) throw std::invalid_argument(message);
}

} // namespace

SurfaceMesh QuadrilateralGrid::triangles() const
{
  SurfaceMesh mesh{points, {}};
  for (const Quadrilateral& q : elements) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

QuadrilateralGrid make_quadrilateral_grid(const BlankParameters& p)
{
  constexpr double most = 1e6;
  require(p.mesh.empty(), "the implicit solver meshes a rectangle itself: it takes no blank.mesh");
  require(std::abs(std::remainder(warp_angle(p) + p.mesh_angle, right_angle)) < 1e-9,
          "quadrilaterals lie along the sides of the blank: fibre_angle + mesh_angle must be a multiple of "
          "90 degrees");
  require(p.symmetry == Symmetry::none, "quadrilaterals mesh the whole blank: symmetry must be \"none\"");
  require(p.elements.has_value() != p.edge.has_value(),
          "the blank needs a number of elements or an edge, one of them");
  const double edge = p.edge ? *p.edge : std::sqrt(p.size.x * p.size.y / *p.elements);
  require(p.size.x * p.size.y / (edge * edge) <= most,
          "the blank would have more than a million quadrilaterals");

  QuadrilateralGrid g;
  g.nx = std::max(1, static_cast<int>(std::lround(p.size.x / edge)));
  g.ny = std::max(1, static_cast<int>(std::lround(p.size.y / edge)));
  const auto place = [](double size, int i, int n) { return size * (2 * i - n) / (2.0 * n); };
  for (int j = 0; j <= g.ny; ++j)
    for (int i = 0; i <= g.nx; ++i) g.points.push_back({place(p.size.x, i, g.nx), place(p.size.y, j, g.ny)});
  for (int j = 0; j < g.ny; ++j)
    for (int i = 0; i < g.nx; ++i)
      g.elements.push_back({g.node(i, j), g.node(i + 1, j), g.node(i + 1, j + 1), g.node(i, j + 1)});
  const YarnDirections yarns = yarn_directions(p);
  g.warp = yarns.warp;
  g.weft = yarns.weft;
  g.thickness = p.thickness;
  return g;
}

} // namespace towform
