#include "solver/interruption.hpp"
#include <csignal>
#include <cstring>
#include <fmt/format.h>

namespace towform {

namespace {
using Seconds = std::chrono::duration<double>;
constexpr double never = 1e9; ///< [s]
} // namespace

Interruption::Interruption(const RunControls& controls, double interval, std::int64_t first_step)
    : controls_(controls), first_step_(first_step),
      interval_(std::chrono::duration_cast<Clock::duration>(Seconds(interval > 0.0 ? interval : never))),
      start_(Clock::now()), next_(start_ + interval_)
{
}

Due Interruption::look(std::int64_t step)
{
  const auto now = Clock::now();
  const int signal = controls_.signal != nullptr ? *controls_.signal : 0;
  if (signal != 0)
    reason_ = fmt::format("SIG{}", sigabbrev_np(signal));
  else if (controls_.max_wall > 0.0 && Seconds(now - start_).count() >= controls_.max_wall)
    reason_ = "--max-wall";
  else if (controls_.max_steps > 0 && step - first_step_ >= controls_.max_steps)
    reason_ = "--max-steps";
  if (!reason_.empty()) return Due::stop;
  if (now < next_) return Due::nothing;
  next_ = now + interval_;
  return Due::checkpoint;
}

} // namespace towform
