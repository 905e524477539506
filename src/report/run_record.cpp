#include "report/run_record.hpp"
#include "compare/point_table.hpp"
#include "output/output_directory.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <limits>

namespace towform {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> text_of(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::map<std::string, std::vector<double>> read_history(const fs::path& path)
{
  const PointTable table = read_points(path);
  std::map<std::string, std::vector<double>> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::vector<double>& column = columns[table.columns[c]];
    for (const PointTable::Row& row : table.rows) {
      double value = 0.0;
      if (!read_number(row.cells[c], value)) value = std::numeric_limits<double>::quiet_NaN();
      column.push_back(value);
    }
  }
  return columns;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The digest that a line of `inputs` gives a file, "" when it names it not.
std::string digest_of(const std::string& inputs, const std::string& file)
{
  const std::string line_end = "  " + file;
  std::size_t begin = 0;
  while (begin < inputs.size()) {
    const std::size_t end = std::min(inputs.find('\n', begin), inputs.size());
    const std::string line = inputs.substr(begin, end - begin);
    if (line.ends_with(line_end)) return line.substr(0, line.size() - line_end.size());
    begin = end + 1;
  }
  return "";
}

} // namespace

double RunRecord::figure(const char* name) const
{
  const auto found = summary.find(name);
  return found != summary.end() && found->is_number() ? found->get<double>()
                                                      : std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> RunRecord::at(const std::string& column, double time) const
{
  const auto times = history.find("time_s"), values = history.find(column);
  if (times == history.end() || values == history.end() || times->second.empty()) return std::nullopt;
  const std::vector<double>&t = times->second, &v = values->second;
  const auto after = static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  if (after == 0) return v.front();
  if (after == t.size()) return v.back();
  const double part = (time - t[after - 1]) / (t[after] - t[after - 1]);
  return v[after - 1] + part * (v[after] - v[after - 1]);
}

RunRecord read_run(const fs::path& directory)
{
  RunRecord run;
  run.directory = directory;
  std::error_code ignored;
  if (!fs::is_directory(directory, ignored))
    throw FileError(fmt::format("{}: there is no such directory", directory.string()));
  run.goes_on = is_in_use(directory);
  run.sheet = read_sheet(directory / "results.h5", std::nullopt);
  const auto gap = [&](const char* file, const std::string& why) {
    run.gaps.push_back(fmt::format("{}: {}", file, why));
  };
  run.resolved_case = text_of(directory / "case.resolved.toml").value_or("");
  try {
    run.run_case = read_case(directory / "case.resolved.toml");
  } catch (const InputError& e) {
    gap("case.resolved.toml", "cannot be read as a case: " + first_line(e.what()));
  }
  try {
    run.history = read_history(directory / "history.csv");
  } catch (const InputError& e) {
    gap("history.csv", "cannot be read: " + first_line(e.what()));
  } catch (const FileError& e) {
    gap("history.csv", std::string("cannot be read: ") + e.what());
  }
  run.summary = nlohmann::ordered_json::object();
  if (run.goes_on) { // one that is there is an earlier run's
    gap("summary.json", "is written when the run ends");
  } else if (const auto text = text_of(directory / "summary.json")) {
    auto json = nlohmann::ordered_json::parse(*text, nullptr, false);
    if (json.is_object())
      run.summary = std::move(json);
    else
      gap("summary.json", "is not JSON");
  } else {
    gap("summary.json", "is not there; it is written when a run ends");
  }
  if (const auto text = text_of(directory / "run.log"))
    run.log = *text;
  else
    gap("run.log", "is not there");
  return run;
}

ToolSurfaces read_tool_surfaces(const Case& c, const std::string& inputs)
{
  ToolSurfaces surfaces;
  for (const ToolParameters& tool : c.tools) {
    surfaces.meshes.emplace_back();
    const std::string file = tool.mesh.string();
    try {
      if (const std::string digest = digest_of(inputs, file);
          !digest.empty() && digest != sha256_of_file(tool.mesh))
        throw FileError(file + " has changed since the run");
      SurfaceMesh mesh = read_stl(tool.mesh, tool.mesh_unit);
      for (Vec3& p : mesh.points) p += tool.position;
      surfaces.meshes.back() = std::move(mesh);
    } catch (const FileError& e) {
      surfaces.gaps.push_back(fmt::format("tool '{}' is not shown: {}", tool.name, first_line(e.what())));
    }
  }
  return surfaces;
}

Vec3 direction_of(const ToolParameters& tool)
{
  return unit_vector(tool.motion ? tool.motion->axis : tool.axis);
}

} // namespace towform
