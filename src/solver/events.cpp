#include "solver/events.hpp"
#include <algorithm>

namespace towform {

std::vector<Event> events_of(const Case& c)
{
  std::vector<Event> events;
  const auto add = [&](int count, bool history, bool frame) {
    for (int i = 1; i <= count; ++i)
      events.push_back({c.time.end * (static_cast<double>(i) / count), history, frame});
  };
  add(c.output.history, true, false);
  add(c.output.frames, true, true); // a frame always has its row
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
  std::vector<Event> merged;
  for (const Event& e : events) {
    if (!merged.empty() && e.time - merged.back().time < 1e-9 * c.time.end) {
      merged.back().frame = merged.back().frame || e.frame;
      continue;
    }
    merged.push_back(e);
  }
  double aim = 0.0;
  for (auto event = merged.rbegin(); event != merged.rend(); ++event) {
    if (event->frame || event == merged.rbegin()) aim = event->time;
    event->aim = aim;
  }
  return merged;
}

} // namespace towform
