#include "material/curve_file.hpp"
#include "case/text_file.hpp"
#include "case/units.hpp"
#include "material/degree.hpp"
#include "towform/error.hpp"
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace towform {

namespace {

constexpr int coefficients = ShearCurve::order + 1;

/// A number of a curve's line; nothing when `word` is not one.
std::optional<double> number(const std::string& word)
{
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

class Reader {
public:
  explicit Reader(const std::filesystem::path& path) : path_(path) {}

  CurveFile read()
  {
    std::istringstream text(read_text(path_, "file of shear curves"));
    std::string line;
    while (std::getline(text, line) && issues_.size() < 5) {
      ++line_;
      if (const std::size_t start = line.find_first_not_of(" \t\r"); start != std::string::npos)
        if (line[start] != '#') read_line(line, start);
    }
    if (issues_.empty()) build();
    if (!issues_.empty()) throw InputError(issues_);
    return std::move(file_);
  }

private:
  struct Row {
    int line;
    std::vector<double> numbers;
  };

  void read_line(const std::string& line, std::size_t start)
  {
    const std::size_t end = std::min(line.find_first_of(" \t\r", start), line.size());
    const std::string word = line.substr(start, end - start);
    if (word == "max_angle")
      setting(line.substr(end), Dimension::angle, 1e-3, 85.0 * degree, "within 0.06 deg .. 85 deg",
              max_angle_);
    else if (word == "temperature")
      setting(line.substr(end), Dimension::temperature, 200.0, 1000.0, "within 200 K .. 1000 K",
              file_.temperature);
    else if (word == "thickness")
      setting(line.substr(end), Dimension::length, 1e-6, 0.1, "within 1 um .. 0.1 m", file_.thickness);
    else if (number(word))
      curve(line);
    else
      issue(line_,
            fmt::format("`{}` is neither a curve's rate nor max_angle, temperature or thickness", word),
            static_cast<int>(start) + 1);
  }

  void setting(std::string text, Dimension dimension, double low, double high, const char* range,
               std::optional<double>& place)
  {
    while (!text.empty() && text.back() == '\r') text.pop_back();
    const Quantity quantity = read_quantity(text, dimension);
    const std::size_t start = text.find_first_not_of(" \t");
    const std::string shown =
        start == std::string::npos ? "nothing" : fmt::format("`{}`", text.substr(start));
    if (!quantity.problem.empty())
      issue(line_, shown + " " + quantity.problem);
    else if (quantity.value < low * (1 - 1e-12) || quantity.value > high * (1 + 1e-12))
      issue(line_, fmt::format("{} must be {}", shown, range));
    else
      place = quantity.value;
  }

  void curve(const std::string& line)
  {
    std::istringstream words(line);
    std::string word;
    Row row{line_, {}};
    while (words >> word) {
      const std::optional<double> value = number(word);
      if (!value) return issue(line_, fmt::format("`{}` is not a number", word));
      row.numbers.push_back(*value);
    }
    if (row.numbers.size() != coefficients + 2)
      return issue(line_, fmt::format("a curve has {} numbers (rate, fit error, a_0 ... a_{}), not {}",
                                      coefficients + 2, ShearCurve::order, row.numbers.size()));
    if (!(row.numbers[0] > 0.0)) return issue(line_, "a curve's rate must be positive");
    if (!(row.numbers[1] >= 0.0)) return issue(line_, "a curve's fit error must not be negative");
    if (!rows_.empty() && row.numbers[0] <= rows_.back().numbers[0])
      return issue(line_,
                   fmt::format("a curve's rate, {} rad/s, must be above that of the curve before it, {}",
                               row.numbers[0], rows_.back().numbers[0]));
    rows_.push_back(std::move(row));
  }

  void build()
  {
    if (!max_angle_) issue(0, "has no line `max_angle`, the angle up to which the curves hold");
    if (rows_.empty()) issue(0, "has no curve");
    if (!issues_.empty()) return;
    for (const Row& row : rows_) {
      ShearCurve::Coefficients powers{};
      std::copy(row.numbers.begin() + 2, row.numbers.end(), powers.begin());
      const ShearCurve curve = ShearCurve::from_powers(row.numbers[0], *max_angle_, powers, row.numbers[1]);
      check_sign(curve, row.line);
      file_.curves.fit_error = std::max(file_.curves.fit_error, curve.fit_error());
      file_.curves.curves.push_back(curve);
    }
  }

  /// A sheet resists shear. A fit may dip below zero by a hair where the force starts from nothing.
  void check_sign(const ShearCurve& curve, int line)
  {
    double least = 0.0, most = 0.0, at = 0.0;
    for (int i = 0; i <= 400; ++i) {
      const double theta = curve.max_angle() * i / 400, force = curve.force(theta);
      most = std::max(most, force);
      if (force < least) {
        least = force;
        at = theta;
      }
    }
    if (most <= 0.0)
      issue(line, "the curve's force is nowhere positive");
    else if (least < -0.01 * most)
      issue(line, fmt::format("the curve's force is negative, {:.3g} N/m at {:.1f} deg", least, at / degree));
  }

  void issue(int line, const std::string& message, int column = 1)
  {
    issues_.push_back({{path_.string(), line, line == 0 ? 0 : column}, message, ExitCode::files});
  }

  std::filesystem::path path_;
  CurveFile file_;
  std::optional<double> max_angle_;
  std::vector<Row> rows_;
  std::vector<InputIssue> issues_;
  int line_ = 0;
};

} // namespace

void write_curves(const std::filesystem::path& path, const CurveFile& file)
{
  std::string text = "# Shear curves of a sheet: shear force per length N [N/m] over the shear angle theta,\n"
                     "# one curve an angular rate:\n"
                     "#   N = a_0 + a_1 x + a_2 x^2 + ... + a_11 x^11,   x = 2 theta/max_angle - 1,\n"
                     "# for 0 <= theta <= max_angle; straight on above. The fit error is the largest\n"
                     "# |curve - source|/source. Lines beginning with # are not read.\n";
  for (const std::string& note : file.notes) text += "# " + note + '\n';
  text += fmt::format("max_angle {:.12g} deg\n", file.curves.curves.front().max_angle() / degree);
  if (file.temperature) text += fmt::format("temperature {:.10g} degC\n", *file.temperature - 273.15);
  if (file.thickness) text += fmt::format("thickness {:.10g} mm\n", 1e3 * *file.thickness);
  text += "# rate [rad/s], fit error, a_0 ... a_11 [N/m]\n";
  for (const ShearCurve& curve : file.curves.curves) {
    text += fmt::format("{:.12g} {:.2e}", curve.rate(), curve.fit_error());
    for (const double a : curve.powers()) text += fmt::format(" {:.14e}", a);
    text += '\n';
  }
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw FileError(fmt::format("cannot write {}", path.string()));
}

CurveFile read_curves(const std::filesystem::path& path) { return Reader(path).read(); }

} // namespace towform
