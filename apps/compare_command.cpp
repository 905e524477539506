#include "compare_command.hpp"
#include "case/units.hpp"
#include "compare/comparison.hpp"
#include "compare/comparison_text.hpp"
#include "compare/condition.hpp"
#include "output/text_file.hpp"
#include "output/while_written.hpp"
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace towform {

namespace {

/// A number with a unit, or a bare one in `bare_unit`, in SI.
double quantity(const std::string& option, const std::string& text, Dimension dimension,
                const std::string& bare_unit)
{
  const bool bare = read_quantity(text, Dimension::none).problem.empty();
  const Quantity q = read_quantity(bare ? text + " " + bare_unit : text, dimension);
  if (!q.problem.empty()) throw CLI::ValidationError(option, text + " " + q.problem);
  if (!std::isfinite(q.value)) throw CLI::ValidationError(option, text + " is not a finite number");
  return q.value;
}

/// So many lengths between commas [m].
std::vector<double> lengths(const std::string& option, const std::string& text, std::size_t count)
{
  std::vector<double> values;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
    values.push_back(quantity(option, part, Dimension::length, "mm"));
  if (values.size() != count)
    throw CLI::ValidationError(option, fmt::format("{} is not {}", text, count == 2 ? "x,y" : "x,y,z"));
  return values;
}

struct CompareArguments {
  std::string results, reference, from, to, centre, tolerance, rms, file;
  std::vector<std::string> conditions, columns;
  std::optional<int> frame;
  bool reference_coordinates = false, mirror = false, nodal = false;

  [[nodiscard]] ComparisonOptions options(bool outline) const
  {
    ComparisonOptions o;
    o.reference_coordinates = reference_coordinates;
    o.mirror = mirror;
    o.nodal = nodal;
    const auto point = [](const char* option, const std::string& text) -> std::optional<Vec2> {
      if (text.empty()) return std::nullopt;
      const auto v = lengths(option, text, 2);
      return Vec2{v[0], v[1]};
    };
    o.from = point("--from", from);
    o.to = point("--to", to);
    if (!centre.empty()) {
      const auto v = lengths("--centre", centre, 3);
      o.centre = Vec3{v[0], v[1], v[2]};
    }
    const auto limit = [&](const char* option, const std::string& text) -> std::optional<double> {
      if (text.empty()) return std::nullopt;
      const double value = outline ? quantity(option, text, Dimension::length, "mm")
                                   : quantity(option, text, Dimension::angle, "deg") * 180.0 / M_PI;
      if (value < 0.0) throw CLI::ValidationError(option, "must not be negative");
      return value;
    };
    o.tolerance = limit("--tolerance", tolerance);
    o.rms = limit("--rms", rms);
    return o;
  }
};

/// What is wrong with an option is a wrong usage.
template <class Action>
auto usage(const std::string& option, Action action)
{
  try {
    return action();
  } catch (const std::invalid_argument& e) {
    throw CLI::ValidationError(option, e.what());
  }
}

void compare(const CompareArguments& a, ExitCode& code)
{
  std::vector<Condition> conditions;
  for (const std::string& text : a.conditions)
    conditions.push_back(usage("--where", [&] { return read_condition(text); }));
  std::vector<ColumnChoice> choices;
  for (const std::string& text : a.columns)
    choices.push_back(usage("--column", [&] { return read_column_choice(text); }));
  PointTable table = read_points(a.reference);
  keep_rows(table, conditions);
  const ReferencePoints reference = read_columns(table, choices);
  const ComparisonOptions options = a.options(!reference.of(PointRole::shear));
  const std::filesystem::path results = a.results;
  const SheetResult sheet =
      read_while_written(results.parent_path(), 10.0, [&] { return read_sheet(results, a.frame); });
  const Comparison result = usage("towform compare", [&] { return compare(sheet, reference, options); });
  fmt::print("{}, frame {} of 0 to {}, {:g} ms, against {}\n{}", a.results, sheet.frame, sheet.frames - 1,
             1e3 * sheet.time, a.reference,
             comparison_text(result, reference, options.tolerance || options.rms));
  if (!a.file.empty()) {
    replace_file(a.file, comparison_csv(result, reference));
    fmt::print("differences written to {}\n", a.file);
  }
  if (!result.failures.empty()) code = ExitCode::comparison;
}

} // namespace

void add_compare_command(CLI::App& app, ExitCode& code)
{
  CLI::App* command = app.add_subcommand(
      "compare", "compare results with measured or published points; exit code 8 when out of tolerance");
  auto a = std::make_shared<CompareArguments>();
  command->footer(
      "REFERENCE.csv: a line of column names, then points; lines with # are skipped. Units are read from the "
      "names:\n"
      "_mm, _cm, _m or _um of lengths, _deg or _rad of angles. What is compared follows from the columns:\n"
      "  x_mm, y_mm, shear_deg    shear angle of the element over the point in plan; of several the highest, "
      "or\n"
      "                           with z_mm the nearest\n"
      "  x_mm, y_mm               distance of the sheet's outline in plan\n"
      "  arc_mm, shear_deg        along a section, by the length over the sheet: --from x,y --to x,y\n"
      "  polar_deg, shear_deg     along a line on a sphere, by the angle at its centre: --centre x,y,z --to "
      "x,y\n"
      "Shear is compared by magnitude unless the reference has negative angles. Points outside the sheet "
      "count as\n"
      "out of tolerance.");
  command->add_option("results", a->results, "results.h5 of a run")->required()->type_name("RESULTS.h5");
  command->add_option("reference", a->reference, "points to compare with (CSV)")
      ->required()
      ->type_name("REFERENCE.csv");
  command->add_option("--frame", a->frame, "number of the frame, from 0 (default: the last)")->type_name("N");
  command->add_option("--tolerance", a->tolerance, "largest difference of any point [deg, of outlines mm]")
      ->type_name("VALUE");
  command->add_option("--rms", a->rms, "largest root mean square of the differences [deg, of outlines mm]")
      ->type_name("VALUE");
  command
      ->add_option("--where", a->conditions, "choose rows: COLUMN=VALUE, or with != < <= > >= (repeatable)")
      ->type_name("CONDITION")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--column", a->columns,
                   "take another column: x, y, z, arc, polar or shear=COLUMN (repeatable)")
      ->type_name("ROLE=COLUMN")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--from", a->from, "where the section starts, plan [mm]; outside the sheet: at its edge")
      ->type_name("X,Y");
  command->add_option("--to", a->to, "where the section or line ends, plan [mm]")->type_name("X,Y");
  command->add_option("--centre", a->centre, "centre of the sphere [mm]")->type_name("X,Y,Z");
  command->add_flag("--reference-coordinates", a->reference_coordinates,
                    "points and sections lie on the flat sheet instead of the formed one");
  command->add_flag(
      "--nodal", a->nodal,
      "shear between means at the nodes, in place of the value of the element: closer where it is smooth");
  command->add_flag("--mirror", a->mirror,
                    "fold points of other quarters into the quarter or half that is modelled");
  command->add_option("-o,--output", a->file, "CSV file of the differences to write")->type_name("FILE.csv");
  command->callback([a, &code] { compare(*a, code); });
}

} // namespace towform
