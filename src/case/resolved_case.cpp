#include "key_value.hpp"
#include "towform/case.hpp"
#include <fmt/format.h>

namespace towform {

namespace {

std::string keys_of(const std::string& section, Target target)
{
  std::string text;
  for (const Row& row : key_table()) {
    if (row.section() != section) continue;
    if (is_motion_key(row) && !target.motion()) continue;
    if (!row.only_with.empty() && get_key(row_of(row.only_with), target).empty()) continue;
    if (!row.counts(target.c)) continue;
    const std::string value = get_key(row, target);
    const std::string key = section.empty() ? row.path : row.path.substr(section.size() + 1);
    if (!value.empty()) text += fmt::format("{} = {}\n", key, value);
  }
  return text;
}

} // namespace

std::string resolved_case(const Case& original)
{
  Case c = original; // the table's bindings write as well as read
  std::string text, last = "-";
  for (const Row& row : key_table()) {
    const std::string section = row.section();
    if (section == last) continue;
    last = section;
    if (section.empty()) {
      text += keys_of(section, {c});
    } else if (section == "tool") {
      for (ToolParameters& tool : c.tools) text += "\n[[tool]]\n" + keys_of(section, {c, &tool});
    } else if (section == "boundary") {
      for (BoundaryParameters& boundary : c.boundaries)
        text += "\n[[boundary]]\n" + keys_of(section, {c, nullptr, &boundary});
    } else {
      text += fmt::format("\n[{}]\n{}", section, keys_of(section, {c}));
    }
  }
  return text;
}

} // namespace towform
