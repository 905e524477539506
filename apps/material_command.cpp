#include "material_command.hpp"
#include "case/units.hpp"
#include "material/prediction.hpp"
#include "material/shear_test.hpp"
#include "towform/error.hpp"
#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace towform {

namespace {

constexpr double degree = M_PI / 180.0;

/// A number with a unit, or a bare one in `bare_unit`, in SI; empty text is nothing.
std::optional<double> quantity(const std::string& option, const std::string& text, Dimension dimension,
                               const std::string& bare_unit)
{
  if (text.empty()) return std::nullopt;
  const bool bare = read_quantity(text, Dimension::none).problem.empty();
  const Quantity q = read_quantity(bare ? text + " " + bare_unit : text, dimension);
  if (!q.problem.empty()) throw CLI::ValidationError(option, text + " " + q.problem);
  return q.value;
}

/// Throws InputError (exit code 3) unless the option's value is within a range.
void require_option(bool ok, const std::string& option, const std::string& message)
{
  if (ok) return;
  std::vector<InputIssue> issues(1);
  issues[0].where.file = option;
  issues[0].message = message;
  throw InputError(std::move(issues));
}

void write_file(const std::string& path, const std::string& text)
{
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw FileError("cannot write " + path);
}

struct PredictArguments {
  std::string path, temperature, file, table;
  std::vector<std::string> overrides, temperatures;
  std::vector<double> rates, angles{1, 10, 20, 30, 40, 50, 60, 70};
};

PredictionPoints points_of(const PredictArguments& a)
{
  PredictionPoints points;
  if (!a.rates.empty()) points.rates = a.rates;
  for (const double rate : points.rates)
    require_option(rate > 0.0 && std::isfinite(rate), "--rates",
                   fmt::format("an angular rate must be positive, not {} rad/s", rate));
  for (const double angle : a.angles) {
    require_option(angle >= 0.0 && angle <= 85.0, "--angles",
                   fmt::format("a shear angle must be within 0 and 85 deg, not {} deg", angle));
    points.angles.push_back(angle * degree);
  }
  for (const std::string& text : a.temperatures) {
    const double t = quantity("--temperatures", text, Dimension::temperature, "degC").value();
    require_option(t >= 200.0 && t <= 1000.0, "--temperatures",
                   fmt::format("a temperature must be within 200 K and 1000 K, not {} K", t));
    points.temperatures.push_back(t);
  }
  return points;
}

void predict(const PredictArguments& a)
{
  const PredictionPoints points = points_of(a);
  std::vector<std::string> overrides = a.overrides;
  const auto temperature = quantity("--temperature", a.temperature, Dimension::temperature, "degC");
  if (temperature) overrides.push_back(fmt::format("material.temperature=\"{} K\"", *temperature));
  const Case c = read_material(a.path, overrides);
  const CurveFile curves = predicted_curves(c);
  fmt::print("{}", prediction_text(c, curves, points));
  if (!a.table.empty()) {
    write_file(a.table, prediction_table(c, points));
    fmt::print("table written to {}\n", a.table);
  }
  if (a.file.empty()) return;
  write_curves(a.file, curves);
  fmt::print("curves written to {}\n", a.file);
}

void add_predict(CLI::App& material)
{
  CLI::App* command = material.add_subcommand(
      "predict", "shear resistance from the constituents: a table and a file of curves. Of the case only "
                 "[material] and blank.thickness are read");
  auto a = std::make_shared<PredictArguments>();
  command->add_option("case", a->path, "case file (TOML)")->required()->type_name("CASE.toml");
  command
      ->add_option("--temperature", a->temperature,
                   "of the sheet, in place of the case's: 200 or \"200 degC\"")
      ->type_name("T");
  command->add_option("-o,--output", a->file, "curve file to write, for material.curves")
      ->type_name("FILE.txt");
  command->add_option("--table", a->table, "CSV table to write")->type_name("FILE.csv");
  command->add_option("--rates", a->rates, "angular rates [rad/s]; default 0.1,1,10")->delimiter(',');
  command->add_option("--angles", a->angles, "shear angles [deg], 0 to 85; default 1,10,20,...,70")
      ->delimiter(',');
  command->add_option("--temperatures", a->temperatures, "of the CSV table [degC]; default the sheet's")
      ->delimiter(',');
  command->add_option("--set", a->overrides, "replace or add a key: key.path=value")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->callback([a] { predict(*a); });
}

struct FitArguments {
  std::string path, file, test, side, length, width, thickness, temperature, speed, rate;
};

double length_option(const std::string& option, const std::string& text)
{
  if (text.empty()) throw CLI::ValidationError(option, "is needed for this test");
  const double value = quantity(option, text, Dimension::length, "mm").value();
  require_option(value > 0.0, option, "must be positive, not " + text);
  return value;
}

/// What the points of a test file cannot tell is wrong with that file.
FittedTest fitted(const ShearTest& test, const std::vector<TestRun>& runs, const std::string& path)
{
  try {
    return fit_test(test, runs);
  } catch (const std::domain_error& e) {
    throw FileError(fmt::format("{}: {}", path, e.what()));
  }
}

void fit(const FitArguments& a)
{
  ShearTest test;
  if (a.test == "picture-frame") {
    test.side = length_option("--side", a.side);
  } else {
    test.kind = ShearTest::Kind::bias_extension;
    test.length = length_option("--length", a.length);
    test.width = length_option("--width", a.width);
    require_option(test.length >= 2.0 * test.width, "--length", "must be at least twice --width");
  }
  const auto speed = quantity("--speed", a.speed, Dimension::velocity, "mm/s");
  const auto rate = quantity("--rate", a.rate, Dimension::angular_rate, "rad/s");
  require_option(!speed || *speed > 0.0, "--speed", "must be positive, not " + a.speed);
  require_option(!rate || *rate > 0.0, "--rate", "must be positive, not " + a.rate);
  CurveFile file;
  file.temperature = quantity("--temperature", a.temperature, Dimension::temperature, "degC");
  if (!a.thickness.empty()) file.thickness = length_option("--thickness", a.thickness);
  const FittedTest result = fitted(test, read_test(a.path, test, speed, rate), a.path);
  file.curves = result.curves;
  file.notes = {
      fmt::format("Fitted to the {} test {}", a.test, a.path),
      fmt::format("shear rates measured: {:.4g} .. {:.4g} rad/s", result.rate_min, result.rate_max)};
  if (result.curves.curves.size() == 1)
    file.notes.emplace_back("one run: its curve is taken as it is, at its mean rate");
  fmt::print("{} {}, {} curve(s) up to {:.2f} deg\n", a.test, a.path, result.curves.curves.size(),
             result.curves.curves.front().max_angle() / degree);
  for (const std::string& note : file.notes) fmt::print("{}\n", note);
  for (std::size_t i = 0; i < result.curves.curves.size(); ++i)
    fmt::print("{:10.4g} rad/s: order {}, residual {:.2g} % of the largest force\n",
               result.curves.curves[i].rate(), result.orders[i], 100.0 * result.residuals[i]);
  write_curves(a.file, file);
  fmt::print("curves written to {}\n", a.file);
}

void add_fit(CLI::App& material)
{
  CLI::App* command =
      material.add_subcommand("fit", "curves from a measured picture frame or bias extension");
  auto a = std::make_shared<FitArguments>();
  command->footer("TEST.csv: a line of column names, then numbers; lines with # are skipped.\n"
                  "  displacement_mm | angle_deg             of the crosshead | of shear\n"
                  "  force_N | shear_force_N_per_m           of the crosshead | along the frame's side\n"
                  "  speed_mm_per_s | rate_rad_per_s         of the crosshead | of shear; tell runs apart\n"
                  "Runs at two speeds or more say how the force follows the rate.");
  command->add_option("test", a->path, "measured points (CSV)")->required()->type_name("TEST.csv");
  command->add_option("-o,--output", a->file, "curve file to write")->required()->type_name("FILE.txt");
  command->add_option("--test", a->test, "kind of test")
      ->required()
      ->check(CLI::IsMember({"picture-frame", "bias-extension"}));
  const auto add = [&](const char* name, std::string& place, const char* meaning, const char* type) {
    command->add_option(name, place, meaning)->type_name(type);
  };
  add("--side", a->side, "side of the picture frame [mm]", "LENGTH");
  add("--length", a->length, "of the strip between the grips [mm], at least twice the width", "LENGTH");
  add("--width", a->width, "of the strip [mm]", "LENGTH");
  add("--thickness", a->thickness, "of the sheet [mm]; kept in the file and checked against cases", "LENGTH");
  add("--temperature", a->temperature, "of the test [degC]; kept in the file and checked against cases", "T");
  add("--speed", a->speed, "of the crosshead [mm/s], when the file has no column for it", "SPEED");
  add("--rate", a->rate, "of shear [rad/s], when the file has no column for it", "RATE");
  command->callback([a] { fit(*a); });
}

} // namespace

void add_material_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("material", "shear resistance of a sheet, predicted or measured");
  command->require_subcommand(1);
  add_predict(*command);
  add_fit(*command);
}

} // namespace towform
