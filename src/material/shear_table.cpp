#include "material/shear_table.hpp"
#include "parallel/parallel.hpp"

namespace towform {

ShearTable::ShearTable(const std::function<double(double, double)>& force, double max_angle)
    : cells_per_radian_(angle_cells / max_angle),
      forces_(static_cast<std::size_t>(angle_cells + 1) * rate_points, 0.0F)
{
  parallel_each(angle_cells + 1, [&](int i) {
    const double theta = max_angle * i / angle_cells;
    for (int j = 1; j < rate_points; ++j)
      forces_[static_cast<std::size_t>(i) * rate_points + j] = static_cast<float>(force(theta, rate_of(j)));
  });
}

} // namespace towform
