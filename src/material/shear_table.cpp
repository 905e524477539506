#include "material/shear_table.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace towform {

namespace {

using Forces = std::array<double, ShearTable::rate_points>;

/// Half of what straight lines miss in the middle of the cells round a point of a smooth curve.
double half_missed(const Forces& force, int j)
{
  const double before = ShearTable::rate_of(j) - ShearTable::rate_of(j - 1), after = ShearTable::rate_of(j + 1) - ShearTable::rate_of(j);
  const double bend = ((force[j + 1] - force[j]) / after - (force[j] - force[j - 1]) / before) / (before + after);
  return -0.125 * bend * before * after;
}

/// How far a point of the table is to lie off the curve, so that lines are as far from it at their ends as in their middle. None
/// where the curve bends in a point alone: there lines miss nothing.
double lift(const Forces& force, int j)
{
  if (j < 2 || j + 2 >= ShearTable::rate_points) return 0.0;
  const auto [least, most] = std::minmax({half_missed(force, j - 1), half_missed(force, j), half_missed(force, j + 1)});
  if (!std::isfinite(least + most)) return 0.0; // who gives no force is found where it is
  return least > 0.0 ? least : most < 0.0 ? most : 0.0;
}

} // namespace

ShearTable::ShearTable(const std::function<double(double, double)>& force, double max_angle)
    : cells_per_radian_(angle_cells / max_angle),
      forces_(static_cast<std::size_t>(angle_cells + 1) * rate_points, 0.0F)
{
  parallel_each(angle_cells + 1, [&](int i) {
    const double theta = max_angle * i / angle_cells;
    Forces row{};
    for (int j = 1; j < rate_points; ++j) row[j] = force(theta, rate_of(j));
    float* const kept = forces_.data() + static_cast<std::size_t>(i) * rate_points;
    for (int j = 1; j < rate_points; ++j)
      kept[j] = static_cast<float>(row[j] + lift(row, j));
  });
}

} // namespace towform
