#pragma once
#include "mesh/tool_shapes/quarter.hpp"

namespace towform::shapes {

/// The outer rectangle of a die or a holder, and the line between the dome centres inside it.
struct Plan {
  double half_length = 0.0, half_width = 0.0; ///< m, along x and y
  double centre = 0.0;                        ///< x of the dome centre, m; 0: one dome only

  [[nodiscard]] bool has_middle() const { return centre > 0.0; }

  /// The rim at height z, reached from the line of centres straight out and from the dome centre along rays.
  [[nodiscard]] Curve rectangle(double z) const;
  /// The rim's points, the corner among them.
  [[nodiscard]] Ring rim(Quarter& quarter, double z, double spacing) const;

  /// The line of centres at height z, where the rings of a closed face end.
  [[nodiscard]] Ring spine(Quarter& quarter, double z, int intervals) const;
  [[nodiscard]] Ring spine(Quarter& quarter, double z, double spacing) const;
  [[nodiscard]] Curve spine(double z) const;

  /// Rings strictly between two curves of a flat face; spacing and distance grow evenly from `h_from` to
  /// `h_to`.
  [[nodiscard]] std::vector<Ring> between(Quarter& quarter, const Curve& from, const Curve& to, double h_from,
                                          double h_to, bool cornered) const;

private:
  /// u of the rectangle's corner.
  [[nodiscard]] double corner() const;
  /// Evenly spaced on a curve, u = 1 and the corner among the points.
  [[nodiscard]] Ring even_ring(Quarter& quarter, const Curve& curve, double spacing, bool cornered) const;
};

} // namespace towform::shapes
