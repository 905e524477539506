#pragma once
#include "compare/point_columns.hpp"
#include "output/results_reader.hpp"
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// What is compared, by the columns of the reference.
enum class ComparisonKind {
  field,   ///< x, y (z), shear: of the element over the point in plan, of several the highest or nearest to z
  section, ///< arc, shear: along the line in which an upright plane cuts the sheet
  sphere,  ///< polar, shear: along such a line from under the centre of a sphere, by the angle at that centre
  outline, ///< x, y: distance of the sheet's outline in plan
};

struct ComparisonOptions {
  std::optional<Vec2> from, to;       ///< plan points: of a section; `to` also of a line on a sphere [m]
  std::optional<Vec3> centre;         ///< of the sphere [m]
  bool reference_coordinates = false; ///< on the flat sheet instead of the formed one
  bool nodal =
      false; ///< shear between means at the nodes, in place of the element's own: second order in the edge
  bool mirror = false;             ///< points of other quarters are folded into the modelled one
  std::optional<double> tolerance; ///< of every point [deg or m]
  std::optional<double> rms;       ///< [deg or m]
};

/// One point of the reference against the sheet. Values in deg, those of an outline in m.
struct ComparedPoint {
  ReferencePoint reference;
  std::optional<double> computed; ///< nothing where there is no sheet
  double distance = 0.0;          ///< of the sheet there from the centre of the sphere [m]

  double wanted = 0.0; ///< the reference's value; 0 of an outline
  [[nodiscard]] double difference() const { return *computed - wanted; }
};

struct Comparison {
  ComparisonKind kind = ComparisonKind::field;
  bool magnitudes = false; ///< |shear| was compared
  std::vector<ComparedPoint> points;
  int compared = 0; ///< those on the sheet
  double mean = 0.0, rms = 0.0, largest = 0.0;
  int largest_line = 0;
  std::string hint; ///< when points are outside a part that --mirror would have folded them into
  std::vector<std::string> failures; ///< why it is out of tolerance; empty when it is within
};

/// Compares a sheet with points. Shear is compared by magnitude unless the reference has a negative angle;
/// with `mirror` always, as a mirror changes its sign. An outline's value is positive where the sheet reaches
/// beyond the point. Points where there is no sheet count as out of tolerance, and so does a reference of
/// which no point is on the sheet, even without a tolerance. Throws InputError, code `files`, when columns
/// are missing and std::invalid_argument with a message for the user when the options do not make a
/// comparison.
Comparison compare(const SheetResult& sheet, const ReferencePoints& reference,
                   const ComparisonOptions& options);

} // namespace towform
