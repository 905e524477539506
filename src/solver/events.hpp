#pragma once
#include "towform/case.hpp"
#include <vector>

namespace towform {

/// When something is written: history rows and frames, each evenly over the run.
struct Event {
  double time;
  bool history, frame;
};

/// In the order of their time; a frame always has its row.
std::vector<Event> events_of(const Case& c);

} // namespace towform
