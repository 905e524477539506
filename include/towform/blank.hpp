#pragma once
#include "towform/surface_mesh.hpp"
#include "towform/vec3.hpp"
#include <filesystem>
#include <optional>
#include <vector>

namespace towform {

/// How squares of the blank's grid become triangles; `unstructured` has no grid.
enum class Pattern { cross, diagonal, unstructured };

/// Which part of the blank is modelled: `x` keeps x >= 0 (the plane x = 0 is a mirror), `y` keeps y >= 0,
/// `quarter` both.
enum class Symmetry { none, x, y, quarter };

/// Quadrilaterals are for the implicit solver.
enum class ElementShape { triangle, quadrilateral };

/// The blank of a case: a rectangle, flat in the plane z = 0 and centred on the origin, or a flat mesh of any
/// outline from a file.
struct BlankParameters {
  std::filesystem::path mesh;           ///< found file; empty for a rectangle
  double mesh_unit = 1.0;               ///< length of the file's unit [m]
  Vec2 size;                            ///< whole blank, along x and y [m]
  std::optional<int> elements;          ///< wanted number of elements of the whole blank, or
  std::optional<double> edge;           ///< wanted edge of the grid's squares [m]
  double fibre_angle = 0.0;             ///< warp against x [rad], weft at right angles; or
  std::optional<Vec3> fibre_1, fibre_2; ///< directions of warp and weft in the plane, of any length and angle
  double mesh_angle = 0.0;              ///< grid lines against the warp [rad]
  Pattern pattern = Pattern::diagonal;
  ElementShape element = ElementShape::triangle;
  double thickness = 0.0; ///< [m]
  Vec2 tilt;              ///< of the blank as it lies at the start: about x, then about y [rad]
  Symmetry symmetry = Symmetry::none;
};

/// Parts of a mesh whose nodes are close together, by their first triangles and their first nodes, both ascending.
struct MeshTiles {
  std::vector<int> triangles, nodes;
};

/// The meshed blank. Node numbers follow the plane (neighbours are close in memory).
struct Blank {
  SurfaceMesh mesh;                    ///< flat, counter-clockwise seen from +z
  MeshTiles tiles;                     ///< may be empty
  Vec3 warp, weft;                     ///< unit reference yarn directions f01, f02
  double thickness = 0.0;              ///< [m]
  Vec2 tilt;                           ///< about x, then about y [rad]
  std::vector<int> mirror_x, mirror_y; ///< nodes on the symmetry planes x = 0 and y = 0, ascending

  /// Where the nodes are at the start: the flat mesh, tilted about the origin.
  [[nodiscard]] std::vector<Vec3> start_positions() const;
};

/// Reads the mesh of the blank, or meshes the rectangle. A grid that lies along the rectangle's sides is cut
/// to fit exactly, with lines on both centre lines so that the mesh is its own mirror image; any other grid
/// angle keeps the grid inside and joins it to evenly divided sides by a Delaunay triangulation. Throws
/// std::invalid_argument with a message for the user when the parameters contradict each other or the mesh or
/// ask for more than 20 million elements, FileError and InputError for a mesh file that is not fit
/// (mesh/msh_reader.hpp, mesh/imported_blank.hpp).
Blank make_blank(const BlankParameters& parameters);

} // namespace towform
