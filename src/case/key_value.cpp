#include "key_value.hpp"
#include "overload.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace towform {

std::string get_key(const Row& row, Target& target)
{
  const auto number = [&](double value) { return written(value, row.dimension); };
  return std::visit(
      Overload{
          [&](At<bool> at) { return std::string(at(target) ? "true" : "false"); },
          [&](At<double> at) { return number(at(target)); },
          [&](At<std::optional<double>> at) { return at(target) ? number(*at(target)) : ""; },
          [&](At<int> at) { return fmt::format("{}", at(target)); },
          [&](At<std::optional<int>> at) { return at(target) ? fmt::format("{}", *at(target)) : ""; },
          [&](At<std::string> at) {
            return at(target).empty() && row.default_text == optional ? "" : in_quotes(at(target));
          },
          [&](At<std::filesystem::path> at) {
            return at(target).empty() && row.default_text == optional ? "" : in_quotes(at(target).string());
          },
          [&](At<Vec2> at) { return fmt::format("[{}, {}]", number(at(target).x), number(at(target).y)); },
          [&](At<std::optional<Vec2>> at) {
            return at(target) ? fmt::format("[{}, {}]", number(at(target)->x), number(at(target)->y)) : "";
          },
          [&](At<Vec3> at) {
            const Vec3 v = at(target);
            return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
          },
          [&](At<std::optional<Vec3>> at) -> std::string {
            const std::optional<Vec3> v = at(target);
            return v ? fmt::format("[{}, {}, {}]", number(v->x), number(v->y), number(v->z)) : "";
          },
          [&](const Words& words) -> std::string {
            const int place = words.get(target);
            return place < 0 ? "" : in_quotes(words.names[static_cast<std::size_t>(place)]);
          },
          [&](const MotionAmount& amount) -> std::string {
            const Motion& motion = *target.motion();
            const bool shown = motion.profile != Motion::Profile::table && motion.quantity == amount.quantity;
            return shown ? number(motion.amount) : "";
          },
          [&](const MotionTable&) -> std::string {
            const Motion& motion = *target.motion();
            if (motion.profile != Motion::Profile::table) return "";
            const bool velocity = motion.quantity == Motion::Quantity::velocity;
            std::vector<std::string> points;
            for (const Motion::Point& point : motion.table) {
              points.push_back(
                  fmt::format("[{}, {}]", written(point.time, Dimension::time),
                              written(point.value, velocity ? Dimension::velocity : Dimension::length)));
            }
            return fmt::format("[{}]", fmt::join(points, ", "));
          },
          [&](At<std::vector<double>> at) -> std::string {
            std::vector<std::string> numbers;
            for (const double value : at(target)) numbers.push_back(number(value));
            return numbers.empty() ? "" : fmt::format("[{}]", fmt::join(numbers, ", "));
          },
          [&](At<std::vector<ViscosityPoint>> at) -> std::string {
            std::vector<std::string> points;
            for (const ViscosityPoint& p : at(target))
              points.push_back(
                  fmt::format("[{}, {}]", written(p.rate, Dimension::frequency), number(p.viscosity)));
            return points.empty() ? "" : fmt::format("[{}]", fmt::join(points, ", "));
          },
          [&](At<std::vector<BendingPoint>> at) -> std::string {
            std::vector<std::string> points;
            for (const BendingPoint& p : at(target))
              points.push_back(
                  fmt::format("[{}, {}]", written(p.curvature, Dimension::curvature), number(p.moment)));
            return points.empty() ? "" : fmt::format("[{}]", fmt::join(points, ", "));
          },
          [&](At<std::vector<PressurePoint>> at) -> std::string {
            std::vector<std::string> points;
            for (const PressurePoint& p : at(target))
              points.push_back(fmt::format("[{}, {}]", written(p.time, Dimension::time), number(p.pressure)));
            if (points.size() == 1) return number(at(target).front().pressure);
            return points.empty() ? "" : fmt::format("[{}]", fmt::join(points, ", "));
          },
      },
      row.binding);
}

std::string type_of(const Row& row)
{
  std::string name = dimension_name(row.dimension);
  return std::visit(
      Overload{
          [](At<bool>) { return std::string("true, false"); },
          [&](At<double>) { return std::string(name); },
          [&](At<std::optional<double>>) { return std::string(name); },
          [](At<int>) { return std::string("whole number"); },
          [](At<std::optional<int>>) { return std::string("whole number"); },
          [](At<std::string>) { return std::string("text"); },
          [](At<std::filesystem::path>) { return std::string("path"); },
          [&](At<Vec2>) { return "two " + name + "s"; },
          [&](At<std::optional<Vec2>>) { return "one or two " + name + (name.ends_with("s") ? "es" : "s"); },
          [&](At<Vec3>) { return "three " + name + "s"; },
          [&](At<std::optional<Vec3>>) { return "three " + name + "s"; },
          [](const Words& words) { return fmt::format("{}", fmt::join(words.names, ", ")); },
          [&](const MotionAmount&) { return std::string(name); },
          [](const MotionTable&) { return std::string("table"); },
          [&](At<std::vector<double>>) { return "list of " + name + "s"; },
          [](At<std::vector<ViscosityPoint>>) { return std::string("table"); },
          [](At<std::vector<BendingPoint>>) { return std::string("table"); },
          [&](At<std::vector<PressurePoint>>) { return name + " or table"; },
      },
      row.binding);
}

std::string label(const Row& row, const Target& target)
{
  const std::string section = row.section();
  if (!is_list_section(section) || row.name() == "name") return row.path;
  const std::string& name = target.tool != nullptr ? target.tool->name : target.boundary->name;
  if (name.empty()) return row.path;
  return section + "." + name + row.path.substr(section.size());
}

} // namespace towform
