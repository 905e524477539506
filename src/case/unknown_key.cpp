#include "unknown_key.hpp"
#include "key_table.hpp"
#include "suggestion.hpp"
#include <algorithm>

namespace towform {

namespace {

std::string joined(const std::string& path, const std::string& name)
{
  return path.empty() ? name : path + "." + name;
}

bool is_row(const std::string& path)
{
  const auto& rows = key_table();
  return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.path == path; });
}

/// What the table at `path` may contain: keys and tables.
std::vector<std::string> names_in(const std::string& path)
{
  std::vector<std::string> names;
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const Row& row : key_table()) {
    if (!row.path.starts_with(prefix)) continue;
    const std::string rest = row.path.substr(prefix.size());
    const std::string name = rest.substr(0, rest.find('.'));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string suggestion(const std::string& name, const std::string& path)
{
  const std::vector<std::string> here = names_in(path);
  std::vector<std::string> same_elsewhere, names;
  for (const Row& row : key_table()) {
    if (row.name() == name) same_elsewhere.push_back("`" + row.path + "`");
    names.push_back(row.name());
  }
  for (const std::string& table : names_in("")) {
    if (table == name) same_elsewhere.push_back("[" + name + "]");
  }
  if (!same_elsewhere.empty()) return "; did you mean " + listed(same_elsewhere) + "?";
  if (const std::string near = nearest(name, here); !near.empty()) return did_you_mean(near);
  if (const std::string near = nearest(name, names); !near.empty()) {
    const auto& rows = key_table();
    return did_you_mean(
        std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name() == near; })->path);
  }
  return (path.empty() ? "; a case has " : "; its keys are ") + listed(here, "and");
}

std::string header(const std::string& path)
{
  return is_list_section(path) ? "[[" + path + "]]" : "[" + path + "]";
}

bool is_table_list(const Value& value)
{
  return value.kind == Value::Kind::list && !value.items.empty() && value.items.front().is_table();
}

} // namespace

void find_unknown_keys(const Value& table, const std::string& path, std::vector<InputIssue>& issues)
{
  const std::vector<std::string> names = names_in(path);
  for (const Value& item : table.items) {
    if (issues.size() >= 100) return; // enough to see that this is no case file
    const std::string item_path = joined(path, item.key);
    if (std::find(names.begin(), names.end(), item.key) == names.end()) {
      std::string what = "unknown key `" + item.key + "`";
      if (path.empty() && item.is_table()) what = "unknown table [" + item.key + "]";
      if (path.empty() && is_table_list(item)) what = "unknown table [[" + item.key + "]]";
      if (!path.empty()) what += " in " + header(path);
      issues.push_back({item.key_where, what + suggestion(item.key, path)});
    } else if (is_row(item_path)) {
      continue; // its value is read elsewhere
    } else if (is_list_section(item_path)) {
      if (item.kind != Value::Kind::list) {
        issues.push_back(
            {item.where, "a " + item_path + " begins with " + header(item_path) + ", in two brackets"});
        continue;
      }
      for (const Value& entry : item.items) {
        if (entry.is_table())
          find_unknown_keys(entry, item_path, issues);
        else
          issues.push_back({entry.where, "a " + item_path + " must be a table " + header(item_path) +
                                             ", not " + entry.shown()});
      }
    } else if (!item.is_table()) {
      issues.push_back({item.where, item_path + " must be a table " +
                                        (path.empty() ? header(item_path) : "{ … }") + ", not " +
                                        item.shown()});
    } else {
      find_unknown_keys(item, item_path, issues);
    }
  }
}

} // namespace towform
