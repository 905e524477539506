#pragma once
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace towform {

/// The shear-force surface N_s(theta, rate) on a grid, bilinear between its points: what the solver
/// evaluates. Angles are evenly spaced from 0 to max_angle; rates divide every octave evenly, so that a
/// rate's cell is read off its bits. Below the lowest rate the sheet is Newtonian (N_s proportional to rate);
/// above the highest rate and angle the last cell goes on. N_s(theta, 0) = 0, N_s(-theta, .) = N_s(theta, .).
class ShearTable {
public:
  static constexpr int angle_cells = 340;
  static constexpr int octave_cells = 8;
  static constexpr int lowest_exponent = -7; // 1/128 rad/s
  static constexpr int octaves = 20;         // up to 8192 rad/s

  /// Samples `force(theta, rate)` [N/m] for 0 <= theta <= max_angle [rad], rate > 0 [rad/s].
  ShearTable(const std::function<double(double, double)>& force, double max_angle);

  /// The surface along the rate at one angle.
  class Slice {
  public:
    struct Line {
      double force; ///< N_s at the rate [N/m]
      double slope; ///< dN_s/drate there [N s/(m rad)]
    };
    [[nodiscard]] Line at(double rate) const
    {
      const int cell = cell_of(rate);
      const double f0 = blend(cell), f1 = blend(cell + 1);
      const double r0 = rate_of(cell), r1 = rate_of(cell + 1);
      const double slope = (f1 - f0) / (r1 - r0);
      return {f0 + slope * (rate - r0), slope};
    }

  private:
    friend class ShearTable;
    Slice(const double* low, const double* high, double weight) : low_(low), high_(high), weight_(weight) {}
    [[nodiscard]] double blend(int cell) const { return low_[cell] + weight_ * (high_[cell] - low_[cell]); }
    const double* low_;
    const double* high_;
    double weight_;
  };

  [[nodiscard]] Slice slice(double theta) const
  {
    const double u = (theta < 0.0 ? -theta : theta) * cells_per_radian_;
    const int cell = u < angle_cells - 1 ? static_cast<int>(u) : angle_cells - 1;
    const double* row = forces_.data() + static_cast<std::size_t>(cell) * rate_points;
    return {row, row + rate_points, u - cell};
  }

  /// The rate that the spring of a Maxwell element leaves to its dashpot, as far as one cell tells.
  struct Root {
    double rate;
    int unsettled; ///< 0 where the cell of the given rate holds it, else 1
  };
  /// Solves N_s(theta, rate) + spring rate = target in the cell of `rate`; again from the result until
  /// settled. `spring` [N s/(m rad)]. Without branches, for loops that vectorise.
  [[nodiscard]] static Root root(const double* forces, double cells_per_radian, double theta, double rate,
                                 double target, double spring)
  {
    const double u = (theta < 0.0 ? -theta : theta) * cells_per_radian;
    const double last = angle_cells - 1;
    const auto row = static_cast<int>(u < last ? u : last); // the last also where u is not a number
    const double weight = u - row;
    const int cell = cell_of(rate);
    const int low = row * rate_points + cell, high = low + rate_points;
    const double f0 = forces[low] + weight * (forces[high] - forces[low]);
    const double f1 = forces[low + 1] + weight * (forces[high + 1] - forces[low + 1]);
    const double r0 = rate_of(cell), r1 = rate_of(cell + 1);
    const double slope = (f1 - f0) / (r1 - r0);
    const double found = (target - f0 + slope * r0) / (slope + spring);
    const double result = found > 0.0 ? found : 0.0;
    const double moved = result - rate;
    const double far = (moved < 0.0 ? -moved : moved) - 1e-12 * rate;
    return {result, cell_of(result) == cell ? 0 : far > 0.0 ? 1 : 0};
  }
  [[nodiscard]] const double* forces() const { return forces_.data(); }
  [[nodiscard]] double cells_per_radian() const { return cells_per_radian_; }

  /// N_s [N/m].
  [[nodiscard]] double force(double theta, double rate) const { return slice(theta).at(rate).force; }

  [[nodiscard]] double max_angle() const { return angle_cells / cells_per_radian_; }

  /// Point 0 is rate 0, point 1 the lowest rate of the first octave.
  static double rate_of(int point)
  {
    const std::int64_t position = static_cast<std::int64_t>(point - 1) << shift;
    const double rate = std::bit_cast<double>(lowest_bits + position);
    return point == 0 ? 0.0 : rate;
  }

private:
  static constexpr int rate_points = octaves * octave_cells + 2;
  static constexpr int shift = 52 - 3; // leaves the exponent and the first three bits of the mantissa
  static_assert(octave_cells == 1 << 3);
  static constexpr std::int64_t lowest_bits = static_cast<std::int64_t>(1023 + lowest_exponent) << 52;

  static int cell_of(double rate)
  {
    const std::int64_t cell = ((std::bit_cast<std::int64_t>(rate) - lowest_bits) >> shift) + 1;
    const std::int64_t from_below = cell > 0 ? cell : 0;
    return static_cast<int>(from_below < rate_points - 2 ? from_below : rate_points - 2);
  }

  double cells_per_radian_;
  std::vector<double> forces_; // rows of one angle
};

} // namespace towform
