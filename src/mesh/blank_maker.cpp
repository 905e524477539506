#include "case/float_traps.hpp"
#include "mesh/blank_grid.hpp"
#include "mesh/blank_lattice.hpp"
#include "mesh/imported_blank.hpp"
#include "mesh/renumber.hpp"
#include "mesh/yarn_directions.hpp"
#include "towform/blank.hpp"
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace towform {
namespace {

constexpr double element_limit = 20e6;
constexpr double aspect_limit = 1e4;     // beyond it the points of the short side merge when rounded
constexpr double angle_tolerance = 1e-9; // rad

template <class... Values>
void require(bool fine, fmt::format_string<Values...> message, Values&&... values)
{
  if (!fine) throw std::invalid_argument(fmt::format(message, std::forward<Values>(values)...));
}

bool is_multiple(double angle, double unit)
{
  return std::abs(std::remainder(angle, unit)) <= angle_tolerance;
}

double approximate_count(const BlankParameters& b)
{
  if (b.elements) return *b.elements;
  const double cell = *b.edge * *b.edge * (b.pattern == Pattern::unstructured ? std::sqrt(0.75) : 1.0);
  return triangles_per_cell(b.pattern) * (b.size.x / *b.edge) * (b.size.y / *b.edge) *
         (*b.edge * *b.edge / cell);
}

void validate_size(const BlankParameters& b)
{
  const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
  require(positive(b.size.x) && positive(b.size.y),
          "both sides of the blank must be positive lengths; they are {} m and {} m", b.size.x, b.size.y);
  const double aspect = std::max(b.size.x / b.size.y, b.size.y / b.size.x);
  require(aspect <= aspect_limit, "the blank is {:g} times as long as it is wide; {:g} times is the limit",
          aspect, aspect_limit);
  require(!(b.elements && b.edge), "the blank has both a number of elements and an edge; give one of them");
  require(b.elements || b.edge, "the blank has no mesh size; give the number of elements or the edge");
  require(!b.elements || *b.elements >= 2, "a blank needs at least 2 elements; {} were asked for",
          b.elements.value_or(0));
  require(!b.edge || positive(*b.edge),
          "the edge of the blank's elements must be a positive length; it is {} m", b.edge.value_or(0.0));
  require(approximate_count(b) <= element_limit,
          "the blank would have {:.3g} elements; the limit is {:.3g}: ask for fewer or for longer edges",
          approximate_count(b), element_limit);
}

void validate(const BlankParameters& b)
{
  const UntrappedFloats judging;
  if (b.mesh.empty()) validate_size(b);
  require(std::isfinite(b.fibre_angle) && std::isfinite(b.mesh_angle),
          "the fibre angle and the mesh angle of the blank must be finite");
  require(std::isfinite(b.thickness) && b.thickness >= 0.0,
          "the thickness of the blank must be a positive length; it is {} m", b.thickness);
  const YarnDirections yarns = yarn_directions(b);
  const bool x = b.symmetry == Symmetry::x || b.symmetry == Symmetry::quarter;
  const bool y = b.symmetry == Symmetry::y || b.symmetry == Symmetry::quarter;
  if ((x && !mirrors_itself(yarns, {1, 0, 0})) || (y && !mirrors_itself(yarns, {0, 1, 0})))
    throw std::invalid_argument(
        b.fibre_1
            ? "a blank with symmetry needs yarns that are their own mirror image, which fibre_1 and "
              "fibre_2 are not; mesh the whole blank"
            : fmt::format("a blank with symmetry needs a fibre angle of 0, 45 or 90 degrees, not {:.6g}: "
                          "its yarns are not their own mirror image; mesh the whole blank",
                          b.fibre_angle * 180.0 / std::numbers::pi));
}

SurfaceMesh mesh_along_sides(const BlankParameters& b)
{
  const GridCounts counts =
      b.elements ? grid_for_elements(b.size, *b.elements, b.pattern) : grid_for_edge(b.size, *b.edge);
  return aligned_grid(b.size, counts, b.pattern, b.symmetry);
}

SurfaceMesh mesh_in_part(const BlankParameters& b)
{
  Rectangle part{{-0.5 * b.size.x, -0.5 * b.size.y}, {0.5 * b.size.x, 0.5 * b.size.y}};
  double share = 1.0;
  if (b.symmetry == Symmetry::x || b.symmetry == Symmetry::quarter) {
    part.low.x = 0.0;
    share *= 0.5;
  }
  if (b.symmetry == Symmetry::y || b.symmetry == Symmetry::quarter) {
    part.low.y = 0.0;
    share *= 0.5;
  }
  const double wanted = share * b.elements.value_or(0);
  const double estimate =
      b.edge ? *b.edge : std::sqrt(triangles_per_cell(b.pattern) * b.size.x * b.size.y / *b.elements);
  if (b.pattern == Pattern::unstructured) {
    const auto count = [&](double edge) { return count_unstructured_mesh(part, edge); };
    return unstructured_mesh(part, b.edge ? *b.edge : edge_for_count(wanted, estimate, count));
  }
  const double angle = warp_angle(b) + b.mesh_angle;
  return turned_grid(part, b.edge ? TurnedGrid{*b.edge, angle, b.pattern}
                                  : turned_grid_for_elements(part, wanted, estimate, angle, b.pattern));
}

SurfaceMesh rectangle_mesh(const BlankParameters& b)
{
  const bool aligned =
      b.pattern != Pattern::unstructured && is_multiple(warp_angle(b) + b.mesh_angle, right_angle);
  return aligned ? mesh_along_sides(b) : mesh_in_part(b);
}

SurfaceMesh imported_mesh(const BlankParameters& b)
{
  SurfaceMesh mesh = triangles_of(read_msh(b.mesh, b.mesh_unit), b.mesh.string());
  put_on_mirrors(mesh, b.symmetry);
  return mesh;
}

} // namespace

std::vector<Vec3> Blank::start_positions() const
{
  std::vector<Vec3> positions = mesh.points;
  if (tilt == Vec2{}) return positions;
  const double cx = std::cos(tilt.x), sx = std::sin(tilt.x), cy = std::cos(tilt.y), sy = std::sin(tilt.y);
  for (Vec3& p : positions) {
    const Vec3 about_x{p.x, cx * p.y - sx * p.z, sx * p.y + cx * p.z};
    p = {cy * about_x.x + sy * about_x.z, about_x.y, cy * about_x.z - sy * about_x.x};
  }
  return positions;
}

Blank make_blank(const BlankParameters& parameters)
{
  validate(parameters);
  Blank blank;
  blank.mesh = parameters.mesh.empty() ? rectangle_mesh(parameters) : imported_mesh(parameters);
  blank.tiles = renumber(blank.mesh);
  const YarnDirections yarns = yarn_directions(parameters);
  blank.warp = yarns.warp;
  blank.weft = yarns.weft;
  blank.thickness = parameters.thickness;
  blank.tilt = parameters.tilt;

  const bool at_x = parameters.symmetry == Symmetry::x || parameters.symmetry == Symmetry::quarter;
  const bool at_y = parameters.symmetry == Symmetry::y || parameters.symmetry == Symmetry::quarter;
  const int nodes = static_cast<int>(blank.mesh.points.size());
  for (int node = 0; node < nodes; ++node) {
    if (at_x && blank.mesh.points[node].x == 0.0) blank.mirror_x.push_back(node);
    if (at_y && blank.mesh.points[node].y == 0.0) blank.mirror_y.push_back(node);
  }
  return blank;
}

} // namespace towform
