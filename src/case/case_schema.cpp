#include "towform/case_schema.hpp"
#include "key_value.hpp"
#include "overload.hpp"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace towform {

namespace {

using Json = nlohmann::ordered_json;

/// A number in SI units or text with a unit; a key without a dimension takes text for per cent.
Json number_schema() { return {{"type", {"number", "string"}}}; }
Json list_of(const Json& item) { return {{"type", "array"}, {"items", item}}; }
Json list_of(const Json& item, int count)
{
  Json list = list_of(item);
  list["minItems"] = list["maxItems"] = count;
  return list;
}
Json either(const Json& a, const Json& b) { return {{"anyOf", {a, b}}}; }

Json type_schema(const Row& row)
{
  Json points = list_of(list_of(number_schema(), 2));
  return std::visit(Overload{
                        [](At<bool>) -> Json {
                          return {{"type", "boolean"}};
                        },
                        [](At<double>) { return number_schema(); },
                        [](At<std::optional<double>>) { return number_schema(); },
                        [](At<int>) -> Json {
                          return {{"type", "integer"}};
                        },
                        [](At<std::optional<int>>) -> Json {
                          return {{"type", "integer"}};
                        },
                        [](At<std::string>) -> Json {
                          return {{"type", "string"}};
                        },
                        [](At<std::filesystem::path>) -> Json {
                          return {{"type", "string"}};
                        },
                        [](At<Vec2>) { return list_of(number_schema(), 2); },
                        [](At<std::optional<Vec2>>) { return either(number_schema(), list_of(number_schema(), 2)); },
                        [](At<Vec3>) { return list_of(number_schema(), 3); },
                        [](At<std::optional<Vec3>>) { return list_of(number_schema(), 3); },
                        [](const Words& words) -> Json {
                          return {{"enum", words.names}};
                        },
                        [](const MotionAmount&) { return number_schema(); },
                        [&](const MotionTable&) { return points; },
                        [](At<std::vector<double>>) { return list_of(number_schema()); },
                        [&](At<std::vector<ViscosityPoint>>) { return points; },
                        [&](At<std::vector<BendingPoint>>) { return points; },
                        [&](At<std::vector<PressurePoint>>) { return either(number_schema(), points); },
                    },
                    row.binding);
}

std::string description(const Row& row)
{
  std::string text = row.meaning;
  if (row.dimension != Dimension::none)
    text += fmt::format("\n{} [{}]", dimension_name(row.dimension), si_unit(row.dimension));
  if (!row.range.empty()) text += "\nrange: " + row.range;
  if (row.default_text == required)
    text += "\nrequired";
  else if (row.default_text != optional)
    text += "\ndefault: " + row.default_text;
  return text;
}

Json table_schema() { return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}}; }

/// The table in `object` that a key with more parts belongs to, made when missing.
Json& place_of(Json& object, const std::string& path)
{
  const std::size_t dot = path.find('.');
  Json& properties = object["properties"];
  if (dot == std::string::npos) return properties[path];
  Json& inner = properties[path.substr(0, dot)];
  if (inner.is_null()) inner = table_schema();
  return place_of(inner, path.substr(dot + 1));
}

} // namespace

std::string case_schema()
{
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "A case of towform"}};
  schema.update(table_schema());
  for (const Row& row : key_table()) {
    const std::string section = row.section();
    Json* root = &schema;
    std::string path = row.path;
    if (is_list_section(section)) {
      Json& list = schema["properties"][section];
      if (list.is_null()) list = list_of(table_schema());
      root = &list["items"];
      path = row.path.substr(section.size() + 1);
    }
    Json key = type_schema(row);
    key["description"] = description(row);
    place_of(*root, path) = std::move(key);
  }
  schema["required"] = {"blank", "material", "time"};
  return schema.dump(2) + '\n';
}

} // namespace towform
