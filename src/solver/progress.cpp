#include "solver/progress.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace towform {

namespace {

constexpr std::chrono::milliseconds refresh{200};

int terminal_columns()
{
  winsize size{};
  constexpr int usual = 80;
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

bool colour_wanted()
{
  const char* no_colour = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  return (no_colour == nullptr || *no_colour == '\0') && !(kind != nullptr && std::string(kind) == "dumb");
}

/// "45 s", "12 min", "3.5 h".
std::string duration(double seconds)
{
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100.0 * minute) return fmt::format("{:.0f} min", seconds / minute);
  return fmt::format("{:.1f} h", seconds / hour);
}

nlohmann::ordered_json json_of(const char* event, const ProgressState& s)
{
  nlohmann::ordered_json json{{"event", event},           {"time_s", s.time}, {"end_s", s.end},
                              {"fraction", s.fraction()}, {"step", s.step},   {"dt_s", s.dt}};
  if (s.element) json["dt_element"] = *s.element;
  json["energy_error"] = s.energy_error;
  json["shear_angle_max_deg"] = s.shear_max;
  return json;
}

void print(const nlohmann::ordered_json& json)
{
  fmt::print("{}\n", json.dump());
  std::fflush(stdout);
}

} // namespace

Progress::Progress(const std::filesystem::path& directory, ProgressStyle style, bool goes_on)
    : style_(style), terminal_(isatty(STDOUT_FILENO) != 0), start_(std::chrono::steady_clock::now()),
      shown_(start_)
{
  try {
    auto file =
        std::make_shared<spdlog::sinks::basic_file_sink_st>((directory / "run.log").string(), !goes_on);
    file->set_pattern("%Y-%m-%d %H:%M:%S  %v");
    log_ = std::make_shared<spdlog::logger>("run", file);
  } catch (const spdlog::spdlog_ex& e) {
    throw FileError(e.what());
  }
  if (style == ProgressStyle::words) {
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

double Progress::to_go(const ProgressState& state)
{
  if (!first_fraction_) first_fraction_ = state.fraction();
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double done = state.fraction() - *first_fraction_;
  return done > 0.0 ? elapsed * (1.0 - state.fraction()) / done : 0.0;
}

void Progress::update(const ProgressState& state)
{
  const double seconds = to_go(state);
  if (style_ != ProgressStyle::words || !terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_ < refresh) return;
  shown_ = now;
  static const bool colour = colour_wanted();
  fmt::print("\r{}\x1b[K", bar_text(state, seconds, terminal_columns() - 1, colour));
  std::fflush(stdout);
  bar_shown_ = true;
}

void Progress::output(const ProgressState& state)
{
  const double seconds = to_go(state);
  if (style_ != ProgressStyle::json) return;
  auto json = json_of("progress", state);
  json["seconds_to_go"] = seconds;
  print(json);
}

void Progress::end(const ProgressState& state, const std::string& status, const std::string& message)
{
  if (style_ != ProgressStyle::json) return;
  auto json = json_of("end", state);
  json["status"] = status;
  json["message"] = message;
  print(json);
}

std::string bar_text(const ProgressState& s, double seconds_to_go, int columns, bool colour)
{
  constexpr int width = 24;
  const int done = std::clamp(static_cast<int>(s.fraction() * width), 0, width);
  std::vector<std::string> figures{
      fmt::format("{:5.1f} %", 100.0 * s.fraction()),
      fmt::format("{} to go", duration(seconds_to_go)),
      fmt::format("t {:.2f} ms", 1e3 * s.time),
      fmt::format("step {}", s.step),
      fmt::format("shear {:.1f} deg", s.shear_max),
      fmt::format("energy error {:.2f} %", 100.0 * s.energy_error),
      s.element ? fmt::format("dt {:.3g} us (element {})", 1e6 * s.dt, *s.element)
                : fmt::format("dt {:.3g} us", 1e6 * s.dt),
  };
  std::string text = fmt::format("[{}{:#<{}}{}{:.<{}}]", colour ? "\x1b[36m" : "", "", done,
                                 colour ? "\x1b[0m" : "", "", width - done);
  int used = width + 2;
  for (const std::string& figure : figures) {
    used += 2 + static_cast<int>(figure.size());
    if (used > columns) break;
    text += "  " + figure;
  }
  return text;
}

} // namespace towform
