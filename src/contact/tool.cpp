#include "contact/tool.hpp"

namespace towform {

void advance(const Tool& tool, ToolState& s, double time, double dt, double kick)
{
  if (tool.force) {
    s.velocity += (*tool.force + dot(s.reaction, tool.direction)) / tool.mass * kick;
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
