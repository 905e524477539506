#pragma once
#include "mesh/tool_shapes/dome_surface.hpp"
#include "mesh/tool_shapes/plan.hpp"
#include <string>

namespace towform::shapes {

/// Where a ball rolling along an edge stands, and the unit vector from the ball's contact with the wall to
/// its centre's far side: the wall is touched at centre - radius normal.
struct Edge {
  Vec3 centre;
  Vec3 normal;
};
using EdgeCurve = std::function<Edge(double u)>;

/// Facet sizes across and along rings. `budget` [m] is the chord error both together may use.
struct Facets {
  double across = 0.0;   ///< m, from ring to ring
  Along<double> along{}; ///< m, on a ring
};
/// Sizes on a rounded edge whose curvatures along the edge are given, 1/m; bounds the facets' aspect.
Facets edge_facets(const Plan& plan, double radius, Along<double> curvature, double budget);

/// Part of the chord error that sizes are computed for; the rest is for facets cut askew.
constexpr double chord_share = 0.9;

/// Spacing of flat faces far from any curve, m.
constexpr double flat_spacing = 0.04;

/// Rings of the arc from centre - radius normal (first) to centre + radius end (last).
std::vector<Ring> rounded_edge(Quarter& quarter, const EdgeCurve& edge, double radius, const Vec3& end,
                               const Facets& facets);

/// A punch: flat cap at `top` [m above the apex], wall and domes, apex at `apex_z`.
SurfaceMesh punch(const Plan& plan, const DomeSurface& surface, double apex_z, double top,
                  double chord_error);

/// What a holder is made of besides the curve where the die's flat flange starts.
struct HolderSizes {
  double underside_z, thickness; ///< m
  double clearance, fillet;      ///< m
  Along<double> curvature;       ///< of the flange's start in plan, 1/m
  double chord_error;            ///< m
};
/// A ring over the die's flat flange; `flange_start` gives points of its start and normals away from the
/// punch. Throws std::invalid_argument: fillet against thickness, no flat left, the opening folds over.
SurfaceMesh holder(const Plan& plan, const EdgeCurve& flange_start, const HolderSizes& sizes);

/// Throws std::invalid_argument unless the rectangle leaves a flat face outside `inner`.
void check_flat_face(const Plan& plan, const Curve& inner, const std::string& what);

/// "12.5 mm", for messages.
std::string millimetres(double length);

} // namespace towform::shapes
