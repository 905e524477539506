#include "override.hpp"
#include "key_table.hpp"
#include "suggestion.hpp"
#include <map>

namespace towform {

namespace {

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> parts_of(const std::string& path)
{
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t dot = std::min(path.find('.', start), path.size());
    parts.push_back(trimmed(path.substr(start, dot - start)));
    start = dot + 1;
  }
  return parts;
}

/// The tool or boundary of a name, or null after an issue.
Value* find_named(Value& document, const std::string& section, const std::string& name,
                  const SourceLocation& where, std::vector<InputIssue>& issues)
{
  std::vector<std::string> names;
  if (Value* list = document.find(section); list != nullptr && list->kind == Value::Kind::list) {
    for (Value& entry : list->items) {
      const Value* entry_name = entry.find("name");
      if (entry_name == nullptr) continue;
      if (entry_name->text == name) return &entry;
      names.push_back(entry_name->text);
    }
  }
  std::string message = "there is no " + section + " `" + name + "`";
  const std::string near = nearest(name, names);
  if (!near.empty())
    message += did_you_mean(near);
  else if (!names.empty())
    message += "; the case has " + listed(names, "and");
  issues.push_back({where, message});
  return nullptr;
}

} // namespace

void apply_override(Value& document, const std::string& text, std::vector<InputIssue>& issues)
{
  const SourceLocation where{"--set " + text, 0, 0};
  const std::size_t equals = text.find('=');
  std::vector<std::string> parts = parts_of(text.substr(0, equals));
  bool good = equals != std::string::npos;
  for (const std::string& part : parts) good = good && !part.empty();
  if (!good) {
    issues.push_back({where, "must be key.path=value, such as blank.thickness=\"2 mm\""});
    return;
  }
  Value* table = &document;
  std::size_t next = 0;
  if (is_list_section(parts[0])) {
    if (parts.size() < 3) {
      issues.push_back({where, "a " + parts[0] + "'s key is given as " + parts[0] + ".NAME.key=value"});
      return;
    }
    table = find_named(document, parts[0], parts[1], where, issues);
    if (table == nullptr) return;
    next = 2;
  }
  for (; next + 1 < parts.size(); ++next) {
    Value* child = table->find(parts[next]);
    if (child == nullptr) {
      Value made;
      made.key = parts[next];
      made.where = made.key_where = where;
      table->items.push_back(std::move(made));
      child = &table->items.back();
    }
    if (!child->is_table()) {
      issues.push_back({where, "`" + parts[next] + "` is not a table"});
      return;
    }
    table = child;
  }
  Value value = parse_value(trimmed(text.substr(equals + 1)), where);
  value.key = parts.back();
  // Of two keys that exclude each other, the one on the command line is meant.
  static const std::map<std::string, std::string> excluded{
      {"elements", "edge"},         {"edge", "elements"}, {"displacement", "velocity"},
      {"velocity", "displacement"}, {"force", "motion"},  {"motion", "force"}};
  if (const auto rival = excluded.find(value.key); rival != excluded.end())
    std::erase_if(table->items, [&](const Value& item) { return item.key == rival->second; });
  if (Value* old = table->find(value.key))
    *old = std::move(value);
  else
    table->items.push_back(std::move(value));
}

} // namespace towform
