#pragma once
#include <array>
#include <chrono>
#include <cstddef>

namespace towform {

enum class Phase { advance, membrane, assembly, bending, contact, stable_step, output, count };

constexpr std::array<const char*, static_cast<std::size_t>(Phase::count)> phase_names{
    "advance", "membrane", "assembly", "bending", "contact", "stable_step", "output"};

/// Wall time of each phase since the start [s].
class Phases {
public:
  /// Adds the time since the last mark to a phase.
  void mark(Phase phase)
  {
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  /// Time until now belongs to no phase.
  void begin() { last_ = Clock::now(); }
  /// Of every phase, to go on from those of an earlier session.
  [[nodiscard]] std::array<double, static_cast<std::size_t>(Phase::count)>& all() { return seconds_; }
  [[nodiscard]] double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  std::array<double, static_cast<std::size_t>(Phase::count)> seconds_{};
};

} // namespace towform
