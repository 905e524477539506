#include "towform/tool_shapes.hpp"
#include "case/float_traps.hpp"
#include "mesh/tool_shapes/parts.hpp"
#include "mesh/tool_shapes/values.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <stdexcept>

namespace towform {

namespace {

constexpr double mm = 1e-3, degree = std::numbers::pi / 180.0;

ShapeParameter length(const char* name, double value, double min, double max, const char* meaning)
{
  return {name, value, min, max, false, meaning};
}

ShapeParameter angle(const char* name, double value, double min, double max, const char* meaning)
{
  return {name, value, min, max, true, meaning};
}

void add_common(std::vector<ShapeParameter>& p)
{
  p.push_back(length("holder-thickness", 10 * mm, 0.1 * mm, 1, "holder, underside to top; assumed"));
  p.push_back(
      length("holder-fillet", 5 * mm, 0.1 * mm, 1, "radius of the holder's inner lower edge; assumed"));
  p.push_back(length("holder-clearance", 0 * mm, 0, 1,
                     "start of the die's flat flange to the holder's opening; assumed"));
  p.push_back(length("sheet-thickness", 1 * mm, 0.01 * mm, 50 * mm,
                     "the tools start on both faces of this sheet, mid-plane z = 0"));
  p.push_back(
      length("chord-error", 0.02 * mm, 0.001 * mm, 5 * mm, "farthest a facet may be from the exact surface"));
}

ToolShape double_dome()
{
  ToolShape shape;
  shape.name = "double-dome";
  shape.meaning =
      "two end domes joined by a waist; the benchmark's drawing is lost, so most sizes are assumed";
  shape.parts = {"punch", "die", "holder"};
  shape.parameters = {
      length("dome-radius", 65 * mm, 5 * mm, 2, "radius of the punch's two end domes; assumed"),
      length("dome-distance", 240 * mm, 5 * mm, 5,
             "between the domes' centres, which lie on the x axis; assumed"),
      length("waist-half-width", 55 * mm, 1 * mm, 2,
             "half-width of the punch midway between the domes; assumed"),
      length("depth", 60 * mm, 2 * mm, 2, "travel of the punch to closure; known"),
      length("entry-fillet", 12 * mm, 0.5 * mm, 1, "radius between the die's cavity and its flange; assumed"),
      angle("draft", 5 * degree, 0, 30 * degree, "of the punch's wall against the vertical; assumed"),
      length("gap", 3 * mm, 0.1 * mm, 0.2, "punch to die at closure, along the normal; known"),
      length("skirt", 20 * mm, 1 * mm, 2, "punch wall above the depth; assumed"),
      length("base", 20 * mm, 1 * mm, 2, "die below the lowest point of its cavity; assumed"),
      length("flange-length", 700 * mm, 10 * mm, 10,
             "die and holder along x; assumed, for a blank of 650 x 450 mm (known of the benchmark's die: "
             "470 mm)"),
      length("flange-width", 500 * mm, 10 * mm, 10,
             "die and holder along y; assumed, for a blank of 650 x 450 mm (known of the benchmark's die: "
             "270 mm)"),
  };
  add_common(shape.parameters);
  shape.builder = [p = shape.parameters](const std::string& part, const std::vector<double>& values) {
    return shapes::build_double_dome(part, shapes::Values(p, values));
  };
  return shape;
}

ToolShape hemisphere()
{
  ToolShape shape;
  shape.name = "hemisphere";
  shape.meaning = "a hemispherical punch through a round opening";
  shape.parts = {"punch", "die", "holder"};
  shape.parameters = {
      length("dome-radius", 75 * mm, 5 * mm, 2, "radius of the punch; known"),
      length("opening-radius", 80 * mm, 5 * mm, 2, "radius of the die's opening, a through-hole; known"),
      length("depth", 75 * mm, 1 * mm, 2, "travel of the punch; assumed, the whole hemisphere"),
      length("entry-fillet", 7.5 * mm, 0.5 * mm, 1, "radius between the die's opening and its flange; known"),
      length("skirt", 20 * mm, 1 * mm, 2,
             "punch cylinder above the equator, or above the depth if that is more; assumed"),
      length("die-thickness", 40 * mm, 1 * mm, 2, "die, flange to bottom; assumed"),
      length("flange-length", 340 * mm, 10 * mm, 10,
             "die and holder along x; assumed, for a blank of 300 x 300 mm"),
      length("flange-width", 340 * mm, 10 * mm, 10,
             "die and holder along y; assumed, for a blank of 300 x 300 mm"),
  };
  add_common(shape.parameters);
  shape.builder = [p = shape.parameters](const std::string& part, const std::vector<double>& values) {
    return shapes::build_hemisphere(part, shapes::Values(p, values));
  };
  return shape;
}

ToolShape male_dome()
{
  ToolShape shape;
  shape.name = "male-dome";
  shape.meaning =
      "a long hill with cosine flanks and round ends, and the press that closes over it: near the "
      "double-size double dome of Pierce and Falzon 2017";
  shape.parts = {"mould", "press"};
  shape.parameters = {
      length("line-length", 610 * mm, 5 * mm, 10,
             "of the line along x that the hill is laid round; "
             "read off published pictures"),
      length("crown", 27 * mm, 1 * mm, 2, "half-width of the level top; read off published pictures"),
      length("flank", 102.6 * mm, 5 * mm, 5,
             "from the top's edge to the foot, in plan; read off published "
             "pictures"),
      length("height", 120 * mm, 1 * mm, 2, "of the hill; known"),
      length("gap", 3 * mm, 0.1 * mm, 0.2,
             "mould to press at closure, along the normal, when the press has "
             "come down by height + sheet-thickness - gap; assumed"),
      length("base", 20 * mm, 1 * mm, 2, "mould below the hill's foot and press above its crown; assumed"),
      length("flange-length", 1100 * mm, 10 * mm, 10, "along x; assumed, for a blank of 800 x 500 mm"),
      length("flange-width", 600 * mm, 10 * mm, 10, "along y; assumed, for a blank of 800 x 500 mm"),
      length("sheet-thickness", 1 * mm, 0.01 * mm, 50 * mm,
             "the tools start on both faces of this sheet, mid-plane z = 0"),
      length("chord-error", 0.1 * mm, 0.001 * mm, 5 * mm, "farthest a facet may be from the exact surface"),
  };
  shape.builder = [p = shape.parameters](const std::string& part, const std::vector<double>& values) {
    return shapes::build_male_dome(part, shapes::Values(p, values));
  };
  return shape;
}

std::string shown(const ShapeParameter& parameter, double value)
{
  return parameter.is_angle ? fmt::format("{:.6g} deg", value / degree) : shapes::millimetres(value);
}

} // namespace

std::vector<double> ToolShape::defaults() const
{
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const ShapeParameter& parameter : parameters) values.push_back(parameter.value);
  return values;
}

SurfaceMesh ToolShape::build(const std::string& part) const { return build(part, defaults()); }

SurfaceMesh ToolShape::build(const std::string& part, const std::vector<double>& values) const
{
  if (std::find(parts.begin(), parts.end(), part) == parts.end())
    throw std::invalid_argument(
        fmt::format("{} has no part \"{}\"; parts are {}", name, part, fmt::join(parts, ", ")));
  if (values.size() != parameters.size())
    throw std::invalid_argument(
        fmt::format("{} has {} parameters, got {} values", name, parameters.size(), values.size()));
  const UntrappedFloats untrapped;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ShapeParameter& p = parameters[i];
    if (!(values[i] >= p.min && values[i] <= p.max)) // also when it is not a number
      throw std::invalid_argument(fmt::format("{} = {} is outside {} to {}", p.name, shown(p, values[i]),
                                              shown(p, p.min), shown(p, p.max)));
  }
  return builder(part, values);
}

const std::vector<ToolShape>& tool_shapes()
{
  static const std::vector<ToolShape> shapes{double_dome(), hemisphere(), male_dome()};
  return shapes;
}

} // namespace towform
