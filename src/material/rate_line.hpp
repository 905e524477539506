#pragma once
#include <vector>

namespace towform {

/// The shear force over the rate at one angle, from its values at a few rates: straight in ln N over ln rate
/// between them, the last segment's power law above. Where the values fall with the rate, rise faster than
/// it, or bend the wrong way, the least line above them that does not is taken: N then rises with the rate
/// and ever less, as a thinning sheet's does, and the viscous law has one answer.
class RateLine {
public:
  enum class Below {
    newtonian,    ///< N proportional to the rate below the lowest
    first_segment ///< the first segment's power law
  };

  /// Rates [rad/s] > 0 in rising order, as many forces [N/m]; forces below `floor` > 0 count as that.
  RateLine(const std::vector<double>& rates, const std::vector<double>& forces, double floor, Below below);

  [[nodiscard]] double force(double rate) const;

private:
  struct Point {
    double rate, force; // natural logarithms
  };
  std::vector<Point> points_; // corners of the hull
  Below below_;
};

} // namespace towform
