#pragma once
#include "towform/case.hpp"
#include <vector>

namespace towform {

/// When something is written: history rows and frames, each evenly over the run.
struct Event {
  double time;
  bool history, frame;
  double aim = 0.0; ///< time of the next frame, or of the last event
};

/// In the order of their time; a frame always has its row.
std::vector<Event> events_of(const Case& c);

} // namespace towform
