#pragma once
#include "mesh/msh_reader.hpp"
#include "towform/blank.hpp"
#include <string>

namespace towform {

/// The triangles of a flat blank from the elements of a file: all normals +z, in one plane z = const exactly.
/// A quadrilateral is cut along the diagonal that leaves the larger smallest angle; when both do, along the
/// shorter one, and along the one that points away from the origin when they are of one length (as in
/// generated blanks, so that a mesh that is its own mirror image stays it). Throws InputError, code `files`,
/// with the line in file `name`: nodes out of plane or on top of each other, elements without area, that
/// cross themselves, that are there twice or that overlap; a blank less than 1 um or more than 1 km wide.
SurfaceMesh triangles_of(const MshMesh& mesh, const std::string& name);

/// Puts the nodes on the mirror planes of a part exactly onto them. Throws std::invalid_argument when the
/// mesh lies on both sides of one or does not reach it.
void put_on_mirrors(SurfaceMesh& mesh, Symmetry symmetry);

} // namespace towform
