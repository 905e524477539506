#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

namespace spdlog {
class logger;
}

namespace towform {

/// What a user sees while a run goes on: lines on standard output and in DIR/run.log, and on a terminal a bar
/// with the time to go.
class Progress {
public:
  /// `quiet` leaves only the log file. Throws FileError when that cannot be written.
  /// A run that goes on appends to its log.
  Progress(const std::filesystem::path& directory, bool quiet, bool goes_on = false);
  ~Progress();
  void line(const std::string& text);
  /// `fraction` of the simulated time done.
  void update(double fraction);

private:
  void erase_bar();

  std::shared_ptr<spdlog::logger> log_;
  bool quiet_, terminal_, bar_shown_ = false;
  std::chrono::steady_clock::time_point start_, shown_;
};

} // namespace towform
