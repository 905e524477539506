#include "contact/tool.hpp"

#include <cmath>

namespace towform {

namespace {
/// Its dashpot [N s/m].
double viscosity(const Tool& tool, const ToolState& s)
{
  return 2.0 * tool.damping * std::sqrt(tool.mass * s.stiffness);
}
} // namespace

double next_velocity(const Tool& tool, const ToolState& s, double kick)
{
  const double half = 0.5 * viscosity(tool, s) / tool.mass * kick;
  const double push = (*tool.force + dot(s.reaction, tool.direction)) / tool.mass * kick;
  return ((1.0 - half) * s.velocity + push) / (1.0 + half);
}

void advance(const Tool& tool, ToolState& s, double time, double dt, double kick)
{
  if (tool.force) {
    const double next = next_velocity(tool, s, kick), mean = 0.5 * (s.velocity + next);
    s.damped += viscosity(tool, s) * mean * mean * kick;
    s.velocity = next;
    s.displacement += s.velocity * dt;
  } else if (tool.motion) {
    const double displacement = tool.motion->displacement(time + dt);
    s.velocity = (displacement - s.displacement) / dt;
    s.displacement = displacement;
  }
}

void account_work(const Tool& tool, ToolState& s, const Vec3& before, double moved)
{
  if (tool.force)
    s.work += *tool.force * moved;
  else if (tool.motion)
    s.work -= 0.5 * dot(before + s.reaction, tool.direction) * moved;
}

} // namespace towform
