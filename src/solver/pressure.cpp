#include "solver/pressure.hpp"
#include "parallel/parallel.hpp"
#include <algorithm>
#include <numeric>

namespace towform {

double Pressure::at(double time) const
{
  const auto after = std::upper_bound(table.begin(), table.end(), time,
                                      [](double t, const PressurePoint& p) { return t < p.time; });
  if (after == table.begin()) return table.front().pressure;
  if (after == table.end()) return table.back().pressure;
  const PressurePoint &from = *(after - 1), &to = *after;
  const double way = (time - from.time) / (to.time - from.time);
  return (1.0 - way) * from.pressure + way * to.pressure;
}

void pressure_forces(const Pressure& pressure, const Membrane& membrane, PressureState& p, State& s)
{
  const double sixth = pressure.at(s.time) / 6.0;
  std::vector<double> work(s.position.size()); // summed in the order of the nodes
  parallel_ranges(static_cast<std::ptrdiff_t>(work.size()), [&](auto begin, auto end) {
    for (auto n = begin; n < end; ++n) {
      Vec3 area; // twice that of the triangles round the node
      for (const int e : pressure.elements.of(static_cast<std::size_t>(n))) {
        const auto& [a, b, c] = membrane.triangles[e];
        area += cross(s.position[b] - s.position[a], s.position[c] - s.position[a]);
      }
      const Vec3 before = p.force[n];
      p.force[n] = -sixth * area;
      s.force[n] += p.force[n];
      work[n] = 0.5 * s.last_dt * dot(before + p.force[n], s.velocity[n]);
    }
  });
  p.work = std::accumulate(work.begin(), work.end(), p.work);
}

} // namespace towform
