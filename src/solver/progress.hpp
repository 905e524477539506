#pragma once
#include <chrono>
#include <string>

namespace towform {

/// What a user sees while a run goes on: lines on standard output, and on a terminal a bar with the time to
/// go.
class Progress {
public:
  explicit Progress(bool quiet);
  ~Progress();
  void line(const std::string& text);
  /// `fraction` of the simulated time done.
  void update(double fraction);

private:
  void erase_bar();

  bool quiet_, terminal_, bar_shown_ = false;
  std::chrono::steady_clock::time_point start_, shown_;
};

} // namespace towform
