#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace spdlog {
class logger;
}

namespace towform {

/// Where a run is. Energy error and shear are those of the last output.
struct ProgressState {
  double time = 0.0, end = 0.0; ///< [s]
  std::int64_t step = 0;
  double dt = 0.0;            ///< [s]
  std::optional<int> element; ///< one of those that limit dt
  double energy_error = 0.0;  ///< over the external work
  double shear_max = 0.0;     ///< [deg]

  [[nodiscard]] double fraction() const { return end > 0.0 ? time / end : 0.0; }
};

enum class ProgressStyle {
  words,
  quiet, ///< the log file alone
  json,  ///< an object a line on standard output, words in the log file alone
};

/// What a user sees while a run goes on: lines on standard output and in DIR/run.log, and on a terminal a bar
/// with the time to go; where standard output is no terminal nothing but lines. Colour only on a terminal
/// and without NO_COLOR in the environment.
class Progress {
public:
  /// Throws FileError when the log file cannot be written. A run that goes on appends to its log.
  Progress(const std::filesystem::path& directory, ProgressStyle style, bool goes_on = false);
  ~Progress();
  void line(const std::string& text);
  /// Moves the bar, not more often than the eye follows.
  void update(const ProgressState& state);
  /// At each output: for JSON an object {"event": "progress", ...}.
  void output(const ProgressState& state);
  /// At the end: for JSON {"event": "end", "status": ...}.
  void end(const ProgressState& state, const std::string& status, const std::string& message);

private:
  void erase_bar();
  [[nodiscard]] double to_go(const ProgressState& state);

  std::shared_ptr<spdlog::logger> log_;
  ProgressStyle style_;
  bool terminal_, bar_shown_ = false;
  std::chrono::steady_clock::time_point start_, shown_;
  std::optional<double> first_fraction_; ///< where this session began
};

/// The bar and figures in one line of at most `columns` characters: what does not fit is left out from the
/// right, figure by figure.
std::string bar_text(const ProgressState& state, double seconds_to_go, int columns, bool colour);

} // namespace towform
