#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace towform {

struct ReportOptions {
  std::size_t limit = 14'000'000; ///< of the packed sheet, fields and tools [bytes]; frames are thinned to it
  double wait = 10.0;             ///< for results that a run is writing and that cannot be read yet [s]
};

/// What came of a report.
struct ReportOutcome {
  std::filesystem::path path;
  std::size_t bytes = 0;
  std::vector<std::string> notes; ///< sentences: what was left out and why
};

/// Writes DIR/report.html, replacing one that is there: one page that needs nothing else, with the formed
/// sheet in 3-D, plots, verdict, case and provenance. Only results.h5 has to be there; what else is missing
/// is said in the page and in the notes. Of a run that goes on it shows what there is. Throws FileError.
ReportOutcome write_report(const std::filesystem::path& directory, const ReportOptions& options = {});

} // namespace towform
