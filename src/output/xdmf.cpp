#include "output/xdmf.hpp"
#include "output/field.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

/// A dataset of results.h5. One dataset per step: the default reader of ParaView 5.11 ignores a HyperSlab of
/// a larger one.
std::string data_item(const std::string& path, std::size_t rows, int components, Field::Number number)
{
  const std::string dimensions =
      components == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, components);
  return fmt::format(
      R"(<DataItem Dimensions="{}" NumberType="{}" Precision="{}" Format="HDF">results.h5:{}</DataItem>)",
      dimensions, number == Field::Number::int32 ? "Int" : "Float", size_of(number), path);
}

const char* attribute_type(int components)
{
  switch (components) {
  case 1:
    return "Scalar";
  case 3:
    return "Vector";
  default:
    return "Matrix"; // any other number of columns
  }
}

std::string attribute(const std::string& name, Field::Centre centre, int components, const std::string& item)
{
  return fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n          {}\n     "
                     "   </Attribute>\n",
                     name, attribute_type(components), centre == Field::Centre::node ? "Node" : "Cell", item);
}

} // namespace

std::string xdmf_frame(std::size_t frame, double time, std::size_t nodes, std::size_t elements, bool with_optional)
{
  const std::string group = fmt::format("/frames/{:04}/", frame);
  std::string text =
      fmt::format("      <Grid Name=\"sheet\" GridType=\"Uniform\">\n        <Time Value=\"{}\"/>\n", time);
  text += fmt::format("        <Topology TopologyType=\"Triangle\" NumberOfElements=\"{}\">\n          {}\n  "
                      "      </Topology>\n",
                      elements, data_item("/mesh/triangles", elements, 3, Field::Number::int32));
  text += fmt::format("        <Geometry GeometryType=\"XYZ\">\n          {}\n        </Geometry>\n",
                      data_item(group + "position", nodes, 3, Field::Number::float64));
  text += attribute("reference", Field::Centre::node, 3,
                    data_item("/mesh/reference", nodes, 3, Field::Number::float64));
  for (const Field& field : fields().subspan(1)) { // position is the geometry
    if (field.optional && !with_optional) continue;
    const std::size_t rows = field.centre == Field::Centre::node ? nodes : elements;
    text += attribute(field.name, field.centre, field.components,
                      data_item(group + field.name, rows, field.components, field.stored));
  }
  return text + "      </Grid>\n";
}

std::string xdmf_text(std::string_view frames)
{
  return fmt::format("<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
                     "    <Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
                     "{}    </Grid>\n  </Domain>\n</Xdmf>\n",
                     frames);
}

} // namespace towform
