#include "case/suggestion.hpp"
#include "case/text_file.hpp"
#include "material/degree.hpp"
#include "material/shear_test.hpp"
#include "towform/error.hpp"
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace towform {

namespace {

constexpr double millimetre = 1e-3;

const std::vector<std::string>& known_columns()
{
  static const std::vector<std::string> names{"displacement_mm",     "angle_deg",      "force_N",
                                              "shear_force_N_per_m", "speed_mm_per_s", "rate_rad_per_s"};
  return names;
}

std::vector<std::string> cells_of(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  std::string cell;
  while (std::getline(stream, cell, ',')) {
    const std::size_t first = cell.find_first_not_of(" \t\r");
    const std::size_t last = cell.find_last_not_of(" \t\r");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

class TestReader {
public:
  TestReader(const std::filesystem::path& path, const ShearTest& test, std::optional<double> speed,
             std::optional<double> rate)
      : path_(path), test_(test), speed_(speed), rate_(rate)
  {
  }

  std::vector<TestRun> read()
  {
    std::istringstream text(read_text(path_, "test file"));
    std::string line;
    while (std::getline(text, line) && issues_.size() < 20) {
      ++line_;
      const std::vector<std::string> cells = cells_of(line);
      const bool blank = cells.empty() || (cells.size() == 1 && cells[0].empty());
      if (blank || cells[0].starts_with('#')) continue;
      if (columns_.empty())
        read_header(cells);
      else
        read_row(cells);
      if (columns_.empty()) break; // nothing can be read without names
    }
    if (issues_.empty() && runs_.empty()) issue(fmt::format("has no measured point"), 0);
    if (!issues_.empty()) throw InputError(issues_);
    std::vector<TestRun> runs;
    for (auto& [pace, run] : runs_) runs.push_back(std::move(run));
    return runs;
  }

private:
  [[nodiscard]] bool has(const std::string& name) const
  {
    return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
  }

  void read_header(const std::vector<std::string>& cells)
  {
    columns_ = cells;
    for (const std::string& name : cells) {
      const auto& known = known_columns();
      if (std::find(known.begin(), known.end(), name) == known.end())
        issue(fmt::format("unknown column `{}`{}", name, did_you_mean(nearest(name, known))));
      if (std::count(cells.begin(), cells.end(), name) > 1) issue(fmt::format("column `{}` twice", name));
    }
    if (!issues_.empty()) return columns_.clear();
    one_of("displacement_mm", "angle_deg");
    one_of("force_N", "shear_force_N_per_m");
    if (has("shear_force_N_per_m") && test_.kind == ShearTest::Kind::bias_extension)
      issue("a bias-extension test needs force_N: its force becomes N only with that of half the angle");
    const int paces = (has("speed_mm_per_s") ? 1 : 0) + (has("rate_rad_per_s") ? 1 : 0) + (speed_ ? 1 : 0) +
                      (rate_ ? 1 : 0);
    if (paces == 0) issue("has no column speed_mm_per_s or rate_rad_per_s; or give --speed or --rate");
    if (paces > 1) issue("more than one of speed_mm_per_s, rate_rad_per_s, --speed and --rate; give one");
    if (!issues_.empty()) columns_.clear();
  }

  void one_of(const std::string& a, const std::string& b)
  {
    if (has(a) == has(b)) issue(fmt::format("needs a column {} or {}{}", a, b, has(a) ? ", not both" : ""));
  }

  void read_row(const std::vector<std::string>& cells)
  {
    if (cells.size() != columns_.size())
      return issue(fmt::format("{} values for {} columns", cells.size(), columns_.size()));
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double value = 0.0;
      const char* end = cells[i].data() + cells[i].size();
      const auto [rest, error] = std::from_chars(cells[i].data(), end, value);
      if (error != std::errc{} || rest != end || !std::isfinite(value))
        return issue(fmt::format("{}: `{}` is not a number", columns_[i], cells[i]));
      row[columns_[i]] = value;
    }
    const bool by_angle = has("angle_deg");
    const double angle =
        by_angle ? row["angle_deg"] * degree : test_.angle(row["displacement_mm"] * millimetre);
    if (!std::isgreaterequal(angle, 0.0) || angle > 85.0 * degree) // not a number when it is out of reach
      return issue(fmt::format("{} {} is outside a shear angle of 0 .. 85 deg",
                               by_angle ? "angle_deg" : "displacement_mm",
                               row[by_angle ? "angle_deg" : "displacement_mm"]));
    for (const char* pace : {"speed_mm_per_s", "rate_rad_per_s"})
      if (has(pace) && !(row[pace] > 0.0)) return issue(fmt::format("{} must be positive", pace));
    TestRun& run = runs_[row[has("rate_rad_per_s") ? "rate_rad_per_s" : "speed_mm_per_s"]];
    run.speed = has("speed_mm_per_s") ? row["speed_mm_per_s"] * millimetre : speed_;
    run.rate = has("rate_rad_per_s") ? row["rate_rad_per_s"] : rate_;
    run.angle.push_back(angle);
    run.force.push_back(has("force_N") ? row["force_N"]
                                       : test_.force(angle, row["shear_force_N_per_m"], 0.0));
  }

  void issue(const std::string& message) { issue(message, line_); }
  void issue(const std::string& message, int line)
  {
    issues_.push_back({{path_.string(), line, line == 0 ? 0 : 1}, message, ExitCode::files});
  }

  std::filesystem::path path_;
  const ShearTest& test_;
  std::optional<double> speed_, rate_;
  std::vector<std::string> columns_;
  std::map<double, TestRun> runs_; // by speed or rate
  std::vector<InputIssue> issues_;
  int line_ = 0;
};

} // namespace

std::vector<TestRun> read_test(const std::filesystem::path& path, const ShearTest& test,
                               std::optional<double> speed, std::optional<double> rate)
{
  return TestReader(path, test, speed, rate).read();
}

} // namespace towform
