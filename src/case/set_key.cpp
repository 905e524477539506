#include "key_value.hpp"
#include "overload.hpp"
#include "range.hpp"
#include "suggestion.hpp"
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

using Kind = Value::Kind;

std::string example(Dimension dimension)
{
  return dimension == Dimension::none ? "0.5" : fmt::format("\"2 {}\"", units_of(dimension).back());
}

/// One key being read.
struct Reading {
  const Row& row;
  Target& target;
  std::vector<InputIssue>& issues;

  void wrong(const Value& value, const std::string& problem) const
  {
    issues.push_back({value.where, fmt::format("{}: {} {}", label(row, target), value.shown(), problem)});
  }

  void must_be(const Value& value, const std::string& what) const
  {
    issues.push_back(
        {value.where, fmt::format("{} must be {}, not {}", label(row, target), what, value.shown())});
  }

  [[nodiscard]] bool in_range(const Value& value, double number) const
  {
    const Range range(row.range, row.dimension);
    if (range.contains(number)) return true;
    const bool within = row.range.find(" .. ") != std::string::npos;
    std::string hint;
    if (row.dimension == Dimension::temperature && value.kind != Kind::text)
      hint = fmt::format("; a number is in K: for Celsius write \"{} degC\"", value.shown());
    wrong(value, fmt::format("must be {}{}{}", within ? "within " : "", row.range, hint));
    return false;
  }

  /// A real number in SI units; nothing when something is wrong.
  [[nodiscard]] std::optional<double> real(const Value& value, Dimension dimension) const
  {
    double number = 0.0;
    if (value.kind == Kind::text) {
      const bool bare = row.bare_unit && is_unit_of(value.text, dimension);
      const Quantity quantity = read_quantity(bare ? "1 " + value.text : value.text, dimension);
      if (!quantity.problem.empty()) {
        wrong(value, quantity.problem);
        return {};
      }
      number = quantity.value;
    } else if (value.kind == Kind::integer) {
      number = static_cast<double>(value.integer);
    } else if (value.kind == Kind::number) {
      number = value.number;
    } else {
      const std::string name = dimension_name(dimension);
      must_be(value,
              fmt::format("{} {}, such as {}", name.front() == 'a' ? "an" : "a", name, example(dimension)));
      return {};
    }
    if (!std::isfinite(number)) {
      wrong(value, "is not a finite number");
      return {};
    }
    if (!in_range(value, number)) return {};
    return number;
  }

  [[nodiscard]] std::optional<int> whole(const Value& value) const
  {
    const double near =
        value.kind == Kind::text ? read_quantity(value.text, Dimension::none).value : value.number;
    if (value.kind == Kind::integer) {
      if (!in_range(value, static_cast<double>(value.integer))) return {};
      return static_cast<int>(value.integer);
    }
    const bool is_whole =
        std::isfinite(near) && near == std::round(near) && std::abs(near) < 1e9 && near != 0.0;
    must_be(value, is_whole ? fmt::format("a whole number: write {:.0f}", near) : "a whole number");
    return {};
  }

  [[nodiscard]] std::optional<bool> truth(const Value& value) const
  {
    if (value.kind == Kind::boolean) return value.boolean;
    must_be(value, "true or false");
    return {};
  }

  template <std::size_t N>
  [[nodiscard]] std::optional<std::array<double, N>> reals(const Value& value) const
  {
    if (value.kind != Kind::list || value.items.size() != N) {
      must_be(value, type_of(row) + (N == 2 ? fmt::format(", such as [{0}, {0}]", example(row.dimension))
                                     : row.dimension == Dimension::length ? ", such as [0, 0, \"5 mm\"]"
                                                                          : ", such as [1, 0, 0]"));
      return {};
    }
    std::array<double, N> numbers{};
    bool good = true;
    for (std::size_t i = 0; i < N; ++i) {
      const std::optional<double> number = real(value.items[i], row.dimension);
      good = good && number;
      numbers[i] = number.value_or(0.0);
    }
    if (!good) return {};
    return numbers;
  }

  [[nodiscard]] std::optional<std::string> text(const Value& value) const
  {
    if (value.kind != Kind::text) {
      must_be(value, "text in quotes");
      return {};
    }
    if (value.text.empty() && row.default_text == required)
      issues.push_back({value.where, label(row, target) + " must not be empty"});
    return value.text;
  }

  void word(const Value& value, const Words& words) const
  {
    std::vector<std::string> choices;
    for (std::size_t i = 0; i < words.names.size(); ++i) {
      if (value.kind == Kind::text && words.names[i] == value.text)
        return words.set(target, static_cast<int>(i));
      choices.push_back(in_quotes(words.names[i]));
    }
    must_be(value, listed(choices));
    if (value.kind == Kind::text) issues.back().message += did_you_mean(nearest(value.text, words.names));
  }

  /// The units of a table's values say what they are; zero needs none.
  [[nodiscard]] std::optional<Motion::Quantity> quantity_of(const Value& table) const
  {
    std::optional<Motion::Quantity> found;
    for (const Value& point : table.items) {
      if (point.kind != Kind::list || point.items.size() != 2 || point.items[1].kind != Kind::text) continue;
      for (const Dimension dimension : dimensions_of(point.items[1].text)) {
        if (dimension != Dimension::length && dimension != Dimension::velocity) continue;
        const auto here =
            dimension == Dimension::length ? Motion::Quantity::displacement : Motion::Quantity::velocity;
        if (found && *found != here) {
          wrong(point.items[1], "mixes displacements and velocities in one table");
          return {};
        }
        found = here;
      }
    }
    if (!found)
      wrong(table, "needs a unit of length or velocity on its values, such as [\"10 ms\", \"-20 mm\"]");
    return found;
  }

  [[nodiscard]] std::vector<double> real_list(const Value& value) const
  {
    std::vector<double> numbers;
    if (value.kind != Kind::list || value.items.empty()) {
      must_be(value, fmt::format("a list, such as [{}]", example(row.dimension)));
      return numbers;
    }
    for (const Value& item : value.items)
      if (const auto number = real(item, row.dimension)) numbers.push_back(*number);
    return numbers;
  }

  /// One value for both of a pair, or a list of two.
  [[nodiscard]] std::optional<Vec2> one_or_two(const Value& value) const
  {
    if (value.kind != Kind::list) {
      const auto both = real(value, row.dimension);
      return both ? std::optional(Vec2{*both, *both}) : std::nullopt;
    }
    if (value.items.size() != 2) {
      const std::string one = example(row.dimension);
      must_be(value, fmt::format("{}, such as {} or [{}, {}]", type_of(row), one, one, one));
      return {};
    }
    const auto first = real(value.items[0], row.dimension), second = real(value.items[1], row.dimension);
    return first && second ? std::optional(Vec2{*first, *second}) : std::nullopt;
  }

  [[nodiscard]] std::vector<BendingPoint> bending_points(const Value& table) const
  {
    std::vector<BendingPoint> points;
    if (table.kind != Kind::list || table.items.empty()) {
      must_be(table, "a list of points, such as [[\"10 1/m\", \"15 mN\"], [\"50 1/m\", \"30 mN\"]]");
      return points;
    }
    for (const Value& item : table.items) {
      if (item.kind != Kind::list || item.items.size() != 2) {
        must_be(item, "a point [curvature, moment per width]");
        continue;
      }
      const auto curvature = real(item.items[0], Dimension::curvature);
      const auto moment = real(item.items[1], row.dimension);
      if (!curvature || !moment) continue;
      if (!points.empty() && *curvature <= points.back().curvature)
        wrong(item.items[0], "must be a greater curvature than the point before it");
      else if (!points.empty() && *moment < points.back().moment)
        wrong(item.items[1], "must not be a smaller moment than the point before it");
      points.push_back({*curvature, *moment});
    }
    return points;
  }

  [[nodiscard]] std::vector<ViscosityPoint> viscosity_points(const Value& table) const
  {
    std::vector<ViscosityPoint> points;
    if (table.kind != Kind::list || table.items.size() < 2) {
      must_be(table, "two or more points, such as [[0.1, \"300 Pa s\"], [10, \"200 Pa s\"]]");
      return points;
    }
    for (const Value& item : table.items) {
      if (item.kind != Kind::list || item.items.size() != 2) {
        must_be(item, "a point [shear rate, viscosity]");
        continue;
      }
      const auto rate = real(item.items[0], Dimension::frequency);
      const auto viscosity = real(item.items[1], Dimension::viscosity);
      if (!rate || !viscosity) continue;
      if (!points.empty() && *rate <= points.back().rate)
        wrong(item.items[0], "must be a higher rate than the point before it");
      else if (!points.empty() && *rate * *viscosity < points.back().rate * points.back().viscosity)
        wrong(item.items[1], "makes the stress, rate times viscosity, fall with the rate");
      points.push_back({*rate, *viscosity});
    }
    return points;
  }

  /// One value for all times, or a table.
  [[nodiscard]] std::vector<PressurePoint> pressure_points(const Value& value) const
  {
    std::vector<PressurePoint> points;
    if (value.kind != Kind::list) {
      if (const auto constant = real(value, row.dimension)) points.push_back({0.0, *constant});
      return points;
    }
    if (value.items.size() < 2)
      must_be(value, "a pressure or two or more points, such as [[0, 0], [\"5 ms\", \"50 kPa\"]]");
    for (const Value& item : value.items) {
      if (item.kind != Kind::list || item.items.size() != 2) {
        must_be(item, "a point [time, pressure]");
        continue;
      }
      const auto time = real(item.items[0], Dimension::time);
      const auto pressure = real(item.items[1], row.dimension);
      if (!time || !pressure) continue;
      if (*time < 0.0) wrong(item.items[0], "must be >= 0");
      if (!points.empty() && *time <= points.back().time)
        wrong(item.items[0], "must be later than the point before it");
      points.push_back({*time, *pressure});
    }
    return points;
  }

  void motion_table(const Value& table) const
  {
    if (table.kind != Kind::list || table.items.size() < 2)
      return must_be(table, "two or more points, such as [[0, \"0 mm\"], [\"60 ms\", \"-60 mm\"]]");
    const std::optional<Motion::Quantity> quantity = quantity_of(table);
    if (!quantity) return;
    Motion& motion = *target.motion();
    motion.quantity = *quantity;
    for (const Value& point : table.items) {
      if (point.kind != Kind::list || point.items.size() != 2) {
        must_be(point, "a point [time, value]");
        continue;
      }
      const std::optional<double> time = real(point.items[0], Dimension::time);
      const std::optional<double> amount = real(
          point.items[1], *quantity == Motion::Quantity::velocity ? Dimension::velocity : Dimension::length);
      if (!time || !amount) continue;
      if (*time < 0.0) wrong(point.items[0], "must be >= 0");
      if (!motion.table.empty() && *time <= motion.table.back().time)
        wrong(point.items[0], "must be later than the point before it");
      motion.table.push_back({*time, *amount});
    }
  }
};

} // namespace

void set_key(const Row& row, const Value& value, Target& target, std::vector<InputIssue>& issues)
{
  const Reading reading{row, target, issues};
  const auto put = [](auto& place, const auto& got) {
    if (got) place = *got;
  };
  std::visit(Overload{
                 [&](At<bool> at) { put(at(target), reading.truth(value)); },
                 [&](At<double> at) { put(at(target), reading.real(value, row.dimension)); },
                 [&](At<std::optional<double>> at) { put(at(target), reading.real(value, row.dimension)); },
                 [&](At<int> at) { put(at(target), reading.whole(value)); },
                 [&](At<std::optional<int>> at) { put(at(target), reading.whole(value)); },
                 [&](At<std::string> at) { put(at(target), reading.text(value)); },
                 [&](At<std::filesystem::path> at) { put(at(target), reading.text(value)); },
                 [&](At<Vec2> at) {
                   if (const auto n = reading.reals<2>(value)) at(target) = {(*n)[0], (*n)[1]};
                 },
                 [&](At<std::optional<Vec2>> at) {
                   if (const auto pair = reading.one_or_two(value)) at(target) = *pair;
                 },
                 [&](At<Vec3> at) {
                   if (const auto n = reading.reals<3>(value)) at(target) = {(*n)[0], (*n)[1], (*n)[2]};
                 },
                 [&](At<std::optional<Vec3>> at) {
                   if (const auto n = reading.reals<3>(value)) at(target) = Vec3{(*n)[0], (*n)[1], (*n)[2]};
                 },
                 [&](const Words& words) { reading.word(value, words); },
                 [&](const MotionAmount& amount) {
                   target.motion()->quantity = amount.quantity;
                   put(target.motion()->amount, reading.real(value, row.dimension));
                 },
                 [&](const MotionTable&) { reading.motion_table(value); },
                 [&](At<std::vector<double>> at) { at(target) = reading.real_list(value); },
                 [&](At<std::vector<ViscosityPoint>> at) { at(target) = reading.viscosity_points(value); },
                 [&](At<std::vector<BendingPoint>> at) { at(target) = reading.bending_points(value); },
                 [&](At<std::vector<PressurePoint>> at) { at(target) = reading.pressure_points(value); },
             },
             row.binding);
}

} // namespace towform
