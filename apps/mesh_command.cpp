#include "mesh_command.hpp"
#include "case/units.hpp"
#include "towform/surface_mesh.hpp"
#include "towform/tool_shapes.hpp"
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

/// A length or angle as in a case file: SI number or number with a unit.
double read_value(const ShapeParameter& parameter, const std::string& text)
{
  const Dimension dimension = parameter.is_angle ? Dimension::angle : Dimension::length;
  const Quantity plain = read_quantity(text, Dimension::none);
  const Quantity quantity = plain.problem.empty() ? plain : read_quantity(text, dimension);
  if (!quantity.problem.empty()) throw CLI::ValidationError("--" + parameter.name, quantity.problem);
  return quantity.value;
}

std::string shown(const ShapeParameter& parameter, double value)
{
  return parameter.is_angle ? fmt::format("{:.6g} deg", value * 180.0 / M_PI)
                            : fmt::format("{:.6g} mm", 1e3 * value);
}

struct MeshArguments {
  std::string part, file;
  std::vector<std::string> values; ///< as given; empty where the default stands
};

void write_part(const ToolShape& shape, const MeshArguments& arguments)
{
  std::vector<double> values = shape.defaults();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!arguments.values[i].empty()) values[i] = read_value(shape.parameters[i], arguments.values[i]);
  SurfaceMesh mesh;
  try {
    mesh = shape.build(arguments.part, values);
  } catch (const std::invalid_argument& e) {
    throw CLI::ValidationError("towform mesh " + shape.name, e.what());
  }
  write_stl(arguments.file, mesh, fmt::format("towform {} {}, metres", shape.name, arguments.part));
  fmt::print("{}: {} {}, {} facets, lengths in metres\n", arguments.file, shape.name, arguments.part,
             mesh.triangles.size());
}

} // namespace

void add_mesh_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("mesh", "write a tool as a binary STL file, lengths in metres");
  command->require_subcommand(1);
  for (const ToolShape& shape : tool_shapes()) {
    CLI::App* sub = command->add_subcommand(shape.name, shape.meaning);
    auto arguments = std::make_shared<MeshArguments>();
    arguments->values.resize(shape.parameters.size());
    sub->add_option("--part", arguments->part, "which tool")->required()->check(CLI::IsMember(shape.parts));
    sub->add_option("-o,--output", arguments->file, "file to write")->required()->type_name("FILE.stl");
    for (std::size_t i = 0; i < shape.parameters.size(); ++i) {
      const ShapeParameter& p = shape.parameters[i];
      sub->add_option(
             "--" + p.name, arguments->values[i],
             fmt::format("{} [{}; {} to {}]", p.meaning, shown(p, p.value), shown(p, p.min), shown(p, p.max)))
          ->type_name(p.is_angle ? "ANGLE" : "LENGTH");
    }
    sub->callback([&shape, arguments] { write_part(shape, *arguments); });
  }
}

} // namespace towform
