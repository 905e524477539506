#include "case_reader.hpp"
#include "data_files.hpp"
#include "key_value.hpp"
#include "text_file.hpp"
#include "unknown_key.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace towform {

namespace {

/// What to say when a whole table is not there.
std::string needs_of(const std::string& section)
{
  if (section == "blank") return "size, thickness, and elements or edge; or mesh and thickness";
  if (section == "material") return "temperature, and a card or every constituent by name";
  std::string keys;
  for (const Row& row : key_table()) {
    if (row.section() == section && row.default_text == required)
      keys += (keys.empty() ? "" : ", ") + row.name();
  }
  return keys;
}

const Value* find_path(const Value* table, const std::string& path)
{
  std::size_t start = 0;
  while (table != nullptr && start <= path.size()) {
    const std::size_t dot = std::min(path.find('.', start), path.size());
    table = table->find(path.substr(start, dot - start));
    start = dot + 1;
  }
  return table;
}

class Reader {
public:
  Reader(Case& c, const Value& document, std::vector<InputIssue>& issues)
      : c_(c), document_(document), issues_(issues)
  {
  }

  void read()
  {
    read_card();
    std::set<std::string> sections;
    for (const Row& row : key_table()) sections.insert(row.section());
    for (const std::string& section : sections) {
      if (section == "tool")
        read_list(section, c_.tools);
      else if (section == "boundary")
        read_list(section, c_.boundaries);
      else
        read_section(section);
    }
  }

  /// [material] and the blank's thickness: all that a prediction needs.
  void read_material()
  {
    read_card();
    read_section("material");
    const Value* thickness = find_path(&document_, "blank.thickness");
    Target target{c_};
    if (thickness == nullptr) return missing(row_of("blank.thickness"), target, "blank");
    c_.locations["blank.thickness"] = thickness->where;
    set_key(row_of("blank.thickness"), *thickness, target, issues_);
  }

private:
  void read_section(const std::string& section)
  {
    static const Value nothing;
    const Value* table = section.empty() ? &document_ : document_.find(section);
    const bool is_table = table != nullptr && table->is_table();
    if (table == nullptr && !needs_of(section).empty()) {
      issue({c_.path.string(), 0, 0},
            fmt::format("table [{}] is missing; it needs {}", section, needs_of(section)));
      return;
    }
    if (table != nullptr && !is_table) return; // already an issue
    if (table != nullptr && !section.empty()) c_.locations[section] = table->where;
    Target target{c_};
    read_keys(section, table == nullptr ? nothing : *table, target, section);
    if (section == "material" && !c_.material.curves.empty()) read_curves_name();
    if (section == "report" && !c_.report.reference.empty())
      find(c_.report.reference, "report.reference", "report.reference");
    if (section == "blank" && !c_.blank.mesh.empty()) find(c_.blank.mesh, "blank.mesh", "blank.mesh");
  }

  Target target_of(ToolParameters& tool) { return {c_, &tool}; }
  Target target_of(BoundaryParameters& boundary) { return {c_, nullptr, &boundary}; }

  /// The tools or the boundaries.
  template <class Parameters>
  void read_list(const std::string& section, std::vector<Parameters>& entries)
  {
    const Value* tables = document_.find(section);
    if (tables == nullptr || tables->kind != Value::Kind::list) return;
    entries.resize(tables->items.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string at = fmt::format("{}[{}]", section, i);
      const Value& table = tables->items[i];
      c_.locations[at] = table.where;
      if (!table.is_table()) continue;
      Target target = target_of(entries[i]);
      if (const Value* motion = table.find("motion"); motion != nullptr && motion->is_table()) {
        target.motion().emplace();
        c_.locations[at + ".motion"] = motion->where;
      }
      read_keys(section, table, target, at);
      if (const Value* mesh = table.find("mesh");
          target.tool != nullptr && mesh != nullptr && !mesh->text.empty())
        read_mesh(*target.tool, at);
    }
  }

  /// The keys of a section; `at` is the section's name in the locations.
  void read_keys(const std::string& section, const Value& table, Target& target, const std::string& at)
  {
    for (const Row& row : key_table()) {
      if (row.section() != section) continue;
      const std::string rest = section.empty() ? row.path : row.path.substr(section.size() + 1);
      if (is_motion_key(row) && !target.motion()) continue;
      const Value* value = find_path(&table, rest);
      if (value == nullptr && section == "material") value = find_path(&card_, rest);
      const bool idle =
          !row.only_with.empty() && find_path(&table, row.only_with.substr(section.size() + 1)) == nullptr;
      if (value != nullptr) {
        note(at.empty() ? rest : fmt::format("{}.{}", at, rest), *value, table);
        set_key(row, *value, target, issues_);
        if (idle)
          issue(value->key_where,
                fmt::format("{} has no effect without {}", label(row, target), row_of(row.only_with).name()));
      } else if (!row.counts(c_)) {
        continue;
      } else if (row.default_text == required) {
        missing(row, target, at);
      } else if (row.default_text != optional && !idle) {
        set_key(row, parse_value(row.default_text, {"default of " + row.path, 0, 0}), target, issues_);
      }
    }
  }

  /// Remembers where a key and the tables round it were given.
  void note(const std::string& key, const Value& value, const Value& section)
  {
    c_.locations[key] = value.where;
    if (const Value* matrix = section.find("matrix");
        matrix != nullptr && key.starts_with("material.matrix."))
      c_.locations["material.matrix"] = matrix->where;
  }

  void missing(const Row& row, const Target& target, const std::string& at)
  {
    const bool of_card = row.section() == "material" && row.path != "material.temperature";
    if (of_card && card_failed_) return;
    const std::string from = of_card && c_.material.card_file.empty() ? ", here or in a card" : "";
    issue(c_.where(at),
          fmt::format("{} is missing{} ({}: {})", label(row, target), from, type_of(row), row.meaning));
  }

  void read_card()
  {
    const Value* name = find_path(&document_, "material.card");
    if (name == nullptr || name->kind != Value::Kind::text) {
      card_failed_ = name != nullptr;
      return;
    }
    const FoundFile found = find_card(name->text, c_.path);
    card_failed_ = true;
    if (!found.problem.empty()) {
      const ExitCode code = name->text.ends_with(".toml") ? ExitCode::files : ExitCode::case_file;
      issue(name->where, fmt::format("material.card: {} {}", name->shown(), found.problem), code);
      return;
    }
    try {
      card_ = parse_document(read_text(found.path, "material card"), found.path.string());
    } catch (const InputError& error) {
      issues_.insert(issues_.end(), error.issues().begin(), error.issues().end());
      return;
    }
    card_failed_ = false;
    c_.material.card_file = found.path;
    find_unknown_keys(card_, "material", issues_);
    if (const Value* nested = card_.find("card")) issue(nested->key_where, "a card cannot name another card");
  }

  void read_curves_name()
  {
    std::filesystem::path& curves = c_.material.curves;
    const SourceLocation where = c_.where("material.curves");
    FoundFile found = find_mesh(curves.string(), c_.path);
    if (!found.problem.empty() && where.file == c_.material.card_file.string())
      found = find_mesh(curves.string(), c_.material.card_file);
    if (found.problem.empty())
      curves = found.path;
    else
      issue(where, fmt::format("material.curves: {} {}", in_quotes(curves.string()), found.problem),
            ExitCode::files);
  }

  void read_mesh(ToolParameters& tool, const std::string& at)
  {
    find(tool.mesh, at + ".mesh", tool.name.empty() ? "tool.mesh" : "tool." + tool.name + ".mesh");
  }

  /// Replaces a mesh's name by the file that it means.
  void find(std::filesystem::path& mesh, const std::string& key, const std::string& shown)
  {
    const FoundFile found = find_mesh(mesh.string(), c_.path);
    if (found.problem.empty())
      mesh = found.path;
    else
      issue(c_.where(key), fmt::format("{}: {} {}", shown, in_quotes(mesh.string()), found.problem),
            ExitCode::files);
  }

  void issue(const SourceLocation& where, std::string message, ExitCode code = ExitCode::case_file)
  {
    issues_.push_back({where, std::move(message), code});
  }

  Case& c_;
  const Value& document_;
  std::vector<InputIssue>& issues_;
  Value card_; ///< its keys; empty without a card
  bool card_failed_ = false;
};

} // namespace

void read_keys_of(const Value& document, Case& c, std::vector<InputIssue>& issues)
{
  find_unknown_keys(document, "", issues);
  Reader(c, document, issues).read();
}

void read_material_keys_of(const Value& document, Case& c, std::vector<InputIssue>& issues)
{
  find_unknown_keys(document, "", issues);
  Reader(c, document, issues).read_material();
}

} // namespace towform
