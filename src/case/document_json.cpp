#include "document_json.hpp"
#include <nlohmann/json.hpp>

namespace towform {

namespace {

using Json = nlohmann::ordered_json;

Json place(const SourceLocation& where) { return {where.line, where.column}; }

Json node(const Value& value)
{
  Json json = {{"value", nullptr}, {"at", place(value.where)}};
  Json& content = json["value"];
  switch (value.kind) {
  case Value::Kind::text:
    content = value.text;
    break;
  case Value::Kind::integer:
    content = value.integer;
    break;
  case Value::Kind::number:
    content = value.number;
    break;
  case Value::Kind::boolean:
    content = value.boolean;
    break;
  case Value::Kind::date:
    break;
  case Value::Kind::list:
    content = Json::array();
    for (const Value& item : value.items) content.push_back(node(item));
    break;
  case Value::Kind::table:
    content = Json::object();
    for (const Value& item : value.items) {
      content[item.key] = node(item);
      content[item.key]["key_at"] = place(item.key_where);
    }
    break;
  }
  return json;
}

} // namespace

std::string document_json(const Value& document) { return node(document).dump(); }

} // namespace towform
