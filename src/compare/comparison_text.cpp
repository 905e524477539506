#include "compare/comparison_text.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

struct Column {
  std::string name;
  std::vector<std::string> cells; // a point each; empty where there is no sheet
};

double shown(PointRole role, double value)
{
  return role == PointRole::polar || role == PointRole::shear ? value : 1e3 * value;
}

std::vector<Column> columns_of(const Comparison& c, const ReferencePoints& reference, const char* number)
{
  const auto text = [&](double value) { return fmt::format(fmt::runtime(number), value + 0.0); };
  std::vector<Column> columns{{"line", {}}};
  for (const ComparedPoint& p : c.points) columns[0].cells.push_back(fmt::format("{}", p.reference.line));
  std::vector<PointRole> place;
  if (c.kind == ComparisonKind::section) place = {PointRole::arc};
  if (c.kind == ComparisonKind::sphere) place = {PointRole::polar};
  if (place.empty()) place = {PointRole::x, PointRole::y};
  if (c.kind == ComparisonKind::field && reference.of(PointRole::z)) place.push_back(PointRole::z);
  for (const PointRole role : place) {
    columns.push_back({role_name(role) + (role == PointRole::polar ? "_deg" : "_mm"), {}});
    for (const ComparedPoint& p : c.points)
      columns.back().cells.push_back(text(shown(role, p.reference[role])));
  }
  const auto add = [&](const char* name, auto value) {
    columns.push_back({name, {}});
    for (const ComparedPoint& p : c.points) columns.back().cells.push_back(p.computed ? text(value(p)) : "");
  };
  if (c.kind == ComparisonKind::outline) {
    add("difference_mm", [](const ComparedPoint& p) { return 1e3 * p.difference(); });
    return columns;
  }
  add("computed_deg", [](const ComparedPoint& p) { return *p.computed; });
  columns.push_back({"reference_deg", {}});
  for (const ComparedPoint& p : c.points) columns.back().cells.push_back(text(p.wanted));
  add("difference_deg", [](const ComparedPoint& p) { return p.difference(); });
  if (c.kind == ComparisonKind::sphere)
    add("radius_mm", [](const ComparedPoint& p) { return 1e3 * p.distance; });
  return columns;
}

std::string what(const Comparison& c)
{
  switch (c.kind) {
  case ComparisonKind::field:
    return "shear angle, point by point";
  case ComparisonKind::section:
    return "shear angle along the section, by arc length";
  case ComparisonKind::sphere:
    return "shear angle along the line, by polar angle; radius_mm is the sheet's distance from the centre";
  case ComparisonKind::outline:
    break;
  }
  return "outline in plan; positive where the sheet reaches beyond the point";
}

} // namespace

std::string comparison_text(const Comparison& c, const ReferencePoints& reference, bool judged)
{
  const auto columns = columns_of(c, reference, "{:.3f}");
  std::string text = what(c) + (c.magnitudes ? "; magnitudes of the angles\n" : "\n");
  const auto line = [&](auto cell) {
    for (const Column& column : columns) text += fmt::format("{:>15}", cell(column));
    while (text.ends_with(' ')) text.pop_back();
  };
  line([](const Column& column) { return column.name; });
  text += '\n';
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    line([&](const Column& column) { return column.cells[i]; });
    text += c.points[i].computed ? "\n" : "   outside the sheet\n";
  }
  const double scale = c.kind == ComparisonKind::outline ? 1e3 : 1.0;
  const char* unit = c.kind == ComparisonKind::outline ? "mm" : "deg";
  if (c.compared > 0)
    text += fmt::format("{} of {} points on the sheet: mean {:.3f}, RMS {:.3f}, max {:.3f} {} (line {})\n",
                        c.compared, c.points.size(), scale * c.mean, scale * c.rms, scale * c.largest, unit,
                        c.largest_line);
  if (!c.hint.empty()) text += c.hint + '\n';
  for (const std::string& failure : c.failures) text += fmt::format("out of tolerance: {}\n", failure);
  if (c.failures.empty()) text += judged ? "within tolerance\n" : "no limit was given (--tolerance, --rms)\n";
  return text;
}

std::string comparison_csv(const Comparison& c, const ReferencePoints& reference)
{
  const auto columns = columns_of(c, reference, "{:.9g}");
  std::string text;
  for (const Column& column : columns) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) text += (k == 0 ? "" : ",") + columns[k].cells[i];
    text += '\n';
  }
  return text;
}

} // namespace towform
