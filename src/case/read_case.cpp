#include "case_reader.hpp"
#include "checks.hpp"
#include "data_files.hpp"
#include "override.hpp"
#include "text_file.hpp"
#include <map>
#include <tuple>

namespace towform {

namespace {

/// The case file first, then its card, then what was set beside it; each from top to bottom.
std::vector<InputIssue> sorted_by_place(const std::vector<InputIssue>& issues, const std::string& case_file)
{
  std::multimap<std::tuple<int, int, int>, const InputIssue*> places; // equal places stay in order
  for (const InputIssue& issue : issues) {
    const SourceLocation& at = issue.where;
    const int group = at.file == case_file ? 0 : at.file.starts_with("--set ") ? 2 : 1;
    places.emplace(std::tuple(group, at.line, at.column), &issue);
  }
  std::vector<InputIssue> sorted;
  for (const auto& [place, issue] : places) sorted.push_back(*issue);
  return sorted;
}

/// What reading a case or its material have in common: `read_keys` writes the document's keys to the case.
template <class ReadKeys>
Case read(const std::filesystem::path& path, const std::vector<std::string>& overrides, ReadKeys read_keys)
{
  Case c;
  c.path = path;
  c.text = read_text(path, "case file");
  Value document = parse_document(c.text, path.string());
  std::vector<InputIssue> issues;
  for (const std::string& text : overrides) apply_override(document, text, issues);
  read_keys(document, c, issues);
  for (ToolParameters& tool : c.tools) {
    if (tool.motion) tool.motion->duration = c.time.end;
  }
  for (BoundaryParameters& boundary : c.boundaries) {
    if (boundary.motion) boundary.motion->duration = c.time.end;
  }
  check_case(c, issues);
  if (!issues.empty()) throw InputError(sorted_by_place(issues, path.string()));
  if (!c.material.card.empty() && !is_own_card(c.material.card_file))
    c.material.card = c.material.card_file.string();
  return c;
}

} // namespace

SourceLocation Case::where(const std::string& key) const
{
  for (std::string at = key; !at.empty(); at.erase(at.rfind('.') == std::string::npos ? 0 : at.rfind('.'))) {
    if (const auto found = locations.find(at); found != locations.end()) return found->second;
  }
  return {path.string(), 0, 0};
}

Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides)
{
  return read(path, overrides, read_keys_of);
}

Case read_material(const std::filesystem::path& path, const std::vector<std::string>& overrides)
{
  return read(path, overrides, read_material_keys_of);
}

} // namespace towform
