#pragma once
#include "output/results_frames.hpp"
#include "output/results_reader.hpp"
#include "towform/case.hpp"
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace towform {

/// What a directory of results holds beside its frames. Only results.h5 has to be there: of a run that goes
/// on there is no summary yet, and what is missing or cannot be read is said in `gaps`.
struct RunRecord {
  std::filesystem::path directory;
  SheetResult sheet; ///< the last frame
  std::optional<Case> run_case;
  std::map<std::string, std::vector<double>> history; ///< columns of history.csv
  nlohmann::ordered_json summary;                     ///< an empty object when there is none
  std::string resolved_case, log;
  std::vector<std::string> gaps; ///< sentences
  bool goes_on = false;          ///< a run had the directory while it was read

  [[nodiscard]] bool has(const std::string& column) const { return history.count(column) > 0; }
  [[nodiscard]] double figure(const char* name) const; ///< of the summary; NaN when it has none
  [[nodiscard]] bool is_preview() const { return summary.value("status", "") == "preview"; }
  /// A column at a time, straight lines between rows; nothing without the column.
  [[nodiscard]] std::optional<double> at(const std::string& column, double time) const;
};

/// Throws FileError when there is no results.h5 with a frame.
RunRecord read_run(const std::filesystem::path& directory);

/// The tools of the case as they were for the run, at time 0, and what to say of those that are not.
struct ToolSurfaces {
  std::vector<std::optional<SurfaceMesh>> meshes; ///< of each tool of the case
  std::vector<std::string> gaps;
};
/// `inputs` are the digests that the results hold: a mesh that has changed since is left out.
ToolSurfaces read_tool_surfaces(const Case& c, const std::string& inputs);

/// A tool's path of travel, a unit vector.
Vec3 direction_of(const ToolParameters& tool);

} // namespace towform
