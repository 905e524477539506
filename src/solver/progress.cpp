#include "solver/progress.hpp"
#include "towform/error.hpp"
#include <cstdio>
#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <unistd.h>

namespace towform {

namespace {
constexpr int bar_width = 40;
constexpr std::chrono::milliseconds refresh{200};
} // namespace

Progress::Progress(const std::filesystem::path& directory, bool quiet, bool goes_on)
    : quiet_(quiet), terminal_(isatty(STDOUT_FILENO) != 0), start_(std::chrono::steady_clock::now()),
      shown_(start_)
{
  try {
    auto file = std::make_shared<spdlog::sinks::basic_file_sink_st>((directory / "run.log").string(), !goes_on);
    file->set_pattern("%Y-%m-%d %H:%M:%S  %v");
    log_ = std::make_shared<spdlog::logger>("run", file);
  } catch (const spdlog::spdlog_ex& e) {
    throw FileError(e.what());
  }
  if (!quiet) {
    auto screen = std::make_shared<spdlog::sinks::stdout_sink_st>();
    screen->set_pattern("%v");
    log_->sinks().push_back(screen);
  }
  log_->flush_on(spdlog::level::info);
}

Progress::~Progress() { erase_bar(); }

void Progress::erase_bar()
{
  if (!bar_shown_) return;
  std::fputs("\r\x1b[K", stdout);
  bar_shown_ = false;
}

void Progress::line(const std::string& text)
{
  erase_bar();
  log_->info(text);
}

void Progress::update(double fraction)
{
  if (quiet_ || !terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_ < refresh) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const int done = static_cast<int>(fraction * bar_width);
  const double to_go = fraction > 0.0 ? elapsed * (1.0 - fraction) / fraction : 0.0;
  fmt::print("\r[{:#<{}}{:.<{}}] {:5.1f} %  {:.0f} s to go \x1b[K", "", done, "", bar_width - done,
             100.0 * fraction, to_go);
  std::fflush(stdout);
  bar_shown_ = true;
}

} // namespace towform
