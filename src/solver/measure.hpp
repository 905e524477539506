#pragma once
#include "mesh/outline.hpp"
#include "solver/energy.hpp"
#include "solver/field_tail.hpp"
#include "solver/model.hpp"
#include "towform/results.hpp"
#include <numbers>

namespace towform {

inline constexpr double to_degrees = 180.0 / std::numbers::pi;

/// How far the blank's outline has moved towards its middle in plan, means over the modelled sides [m]. The
/// middle is that of the flat blank's bounding box (0 across a mirror plane). Six kinds of points of the
/// outline are followed, wherever the outline is met last by a ray from the middle:
struct DrawIn {
  double x_mid = 0.0;  ///< along +x and -x: how much nearer the middle in x
  double y_mid = 0.0;  ///< along +y and -y: in y
  double corner = 0.0; ///< towards the corners of the bounding box: in plan distance
};

/// Remembers which points of the outline stand for the blank's edges. A ray that misses the outline (of an L,
/// a C) takes the outline's node nearest to where it leaves the bounding box; so every blank has all three.
class DrawInGauge {
public:
  explicit DrawInGauge(const Blank& blank);
  [[nodiscard]] DrawIn measure(const System& s) const;

private:
  struct Followed {
    OutlinePoint point;
    double at_start; ///< its distance then [m]
  };
  /// From the middle in plan, x and y weighted [m].
  [[nodiscard]] double distance(const Vec3& p, double wx, double wy) const;
  Vec2 middle_;
  std::vector<Followed> x_mid_, y_mid_, corner_;
};

// What a yarn strain over is counted for:
inline constexpr double much_strain = 0.02, much_compression = 0.005;

/// Extremes over the elements.
struct FieldExtremes {
  double shear_max = 0.0, shear_p99 = 0.0;             ///< |theta| [rad]
  double strain_max = 0.0, strain_p99 = 0.0;           ///< larger |strain| of an element's two yarn families
  double strain_over_2_percent = 0.0;                  ///< fraction of the elements
  double compression_max = 0.0, compression_p99 = 0.0; ///< larger shortening of an element's two families
  double compression_over_half_percent = 0.0;          ///< fraction of the elements
  int most_sheared = 0, most_strained = 0;             ///< elements

  void tell(Summary& summary) const;
};
/// From the tails of these fields, those of strain and compression counted over what is much.
FieldExtremes field_extremes(const FieldTail& shear, const FieldTail& strain, const FieldTail& compression);
FieldExtremes field_extremes(const Membrane& membrane, const System& s);

} // namespace towform
