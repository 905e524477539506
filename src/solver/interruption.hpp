#pragma once
#include "towform/run.hpp"
#include <chrono>
#include <optional>

namespace towform {

/// Between two steps: what has to be done before the next one.
enum class Due { nothing, checkpoint, stop };

/// Watches the wall clock, the count of steps and the user's signals for a run.
class Interruption {
public:
  /// `interval` between checkpoints [s], 0 for none; `first_step` is the one at which this session starts.
  Interruption(const RunControls& controls, double interval, std::int64_t first_step);

  [[nodiscard]] Due look(std::int64_t step);
  /// Once a stop is due, why: "SIGTERM", "--max-wall".
  [[nodiscard]] const std::string& reason() const { return reason_; }

private:
  using Clock = std::chrono::steady_clock;

  RunControls controls_;
  std::int64_t first_step_;
  Clock::duration interval_;
  Clock::time_point start_, next_;
  std::string reason_;
};

} // namespace towform
