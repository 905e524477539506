#pragma once
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace towform {

/// The shear-force surface N_s(theta, rate) on a grid, bilinear between its points, which lie off the surface by half of what
/// straight lines along the rate miss of it: what the solver evaluates. Angles are evenly spaced from 0 to max_angle; rates divide every octave evenly, so that a
/// rate's cell is read off its bits. Below the lowest rate the sheet is Newtonian (N_s proportional to rate);
/// above the highest rate and angle the last cell goes on. Forces are kept in single precision: half the cache, 6e-8 off. N_s(theta, 0) = 0, N_s(-theta, .) = N_s(theta, .).
class ShearTable {
public:
  static constexpr int angle_cells = 340;
  static constexpr int octave_bits = 2, octave_cells = 1 << octave_bits; // finer cells would be left more often
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
      const std::int64_t cell = cell_of(rate);
      const double f0 = blend(cell), f1 = blend(cell + 1);
      const double r0 = rate_of(cell), r1 = rate_of(cell + 1);
      const double slope = (f1 - f0) / (r1 - r0);
      return {f0 + slope * (rate - r0), slope};
    }

  private:
    friend class ShearTable;
    Slice(const float* low, const float* high, double weight) : low_(low), high_(high), weight_(weight) {}
    [[nodiscard]] double blend(std::int64_t cell) const { return double{low_[cell]} + weight_ * (double{high_[cell]} - double{low_[cell]}); }
    const float* low_;
    const float* high_;
    double weight_;
  };

  [[nodiscard]] Slice slice(double theta) const
  {
    const double u = (theta < 0.0 ? -theta : theta) * cells_per_radian_;
    const int cell = u < angle_cells - 1 ? static_cast<int>(u) : angle_cells - 1;
    const float* row = forces_.data() + static_cast<std::size_t>(cell) * rate_points;
    return {row, row + rate_points, u - cell};
  }

  /// A row of angles and how far towards the next.
  struct Row {
    std::int32_t first; ///< of its forces
    double weight;
  };
  [[nodiscard]] static Row row_of(double theta, double cells_per_radian)
  {
    const double u = (theta < 0.0 ? -theta : theta) * cells_per_radian;
    const double last = angle_cells - 1;
    const auto row = static_cast<std::int32_t>(u < last ? u : last); // the last also where u is not a number
    return {row * rate_points, u - row};
  }

  /// The rate that the spring of a Maxwell element leaves to its dashpot, as far as one cell tells.
  struct Root {
    double rate;
    std::int64_t unsettled; ///< 0 where the cell holds it, else 1
  };
  /// Solves N_s(theta, rate) + spring rate = target in the cell of `rate`, from the forces at its ends in the rows
  /// below and above theta; again from the result until settled. `spring` [N s/(m rad)]. Without branches,
  /// for loops that vectorise.
  [[nodiscard]] static Root solve(double low0, double low1, double high0, double high1, double weight,
                                  std::int64_t cell, double rate, double target, double spring)
  {
    const double f0 = low0 + weight * (high0 - low0), f1 = low1 + weight * (high1 - low1);
    const double r0 = rate_of(cell);
    const double slope = (f1 - f0) * over_width(cell);
    const double found = (target - f0 + slope * r0) / (slope + spring);
    const double result = found > 0.0 ? found : 0.0;
    const double moved = result - rate; // at the border of two cells either may point to the other
    const double far = (moved < 0.0 ? -moved : moved) - 1e-12 * rate;
    return {result, cell_of(result) == cell ? 0 : far > 0.0 ? 1 : 0};
  }
  [[nodiscard]] Root root(double theta, double rate, double target, double spring) const
  {
    const Row row = row_of(theta, cells_per_radian_);
    const std::int64_t cell = cell_of(rate);
    const float* low = forces_.data() + row.first + cell;
    const float* high = low + rate_points;
    return solve(low[0], low[1], high[0], high[1], row.weight, cell, rate, target, spring);
  }
  [[nodiscard]] const float* forces() const { return forces_.data(); }
  [[nodiscard]] double cells_per_radian() const { return cells_per_radian_; }

  /// N_s [N/m].
  [[nodiscard]] double force(double theta, double rate) const { return slice(theta).at(rate).force; }

  [[nodiscard]] double max_angle() const { return angle_cells / cells_per_radian_; }

  /// Point 0 is rate 0, point 1 the lowest rate of the first octave.
  static double rate_of(std::int64_t point)
  {
    const std::int64_t position = (point - 1) * (std::int64_t{1} << shift);
    const double rate = std::bit_cast<double>(lowest_bits + position);
    return point == 0 ? 0.0 : rate;
  }

  static constexpr int rate_points = octaves * octave_cells + 2;

  /// Cell of a rate: from point `cell` to the next.
  static std::int64_t cell_of(double rate)
  {
    const std::int64_t cell = ((std::bit_cast<std::int64_t>(rate) - lowest_bits) >> shift) + 1;
    const std::int64_t from_below = cell > 0 ? cell : 0;
    return from_below < rate_points - 2 ? from_below : rate_points - 2;
  }

private:
  /// 1/(width of a cell): octaves are powers of two.
  static double over_width(std::int64_t cell)
  {
    const std::int64_t octave = ((cell + octave_cells - 1) >> octave_bits) - 1;
    const double within = std::bit_cast<double>(((1023LL + octave_bits - lowest_exponent) - octave) << 52);
    constexpr double lowest = static_cast<double>(1 << -lowest_exponent);
    return cell == 0 ? lowest : within;
  }

  static constexpr int shift = 52 - octave_bits; // leaves the exponent and the first bits of the mantissa
  static constexpr std::int64_t lowest_bits = static_cast<std::int64_t>(1023 + lowest_exponent) << 52;

  double cells_per_radian_;
  std::vector<float> forces_; // rows of one angle
};

} // namespace towform
