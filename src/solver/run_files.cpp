#include "solver/run_files.hpp"
#include "solver/provenance.hpp"

namespace towform {

std::unique_ptr<ResultsWriter> open_results(const Case& c, const std::filesystem::path& directory,
                                            const SurfaceMesh& blank, const Record& record)
{
  if (record.frames > 0)
    return std::make_unique<ResultsWriter>(directory, blank, static_cast<int>(record.frames));
  write_resolved_case(c, directory);
  constexpr int first_and_last = 2; // a run that is stopped leaves its last state
  return std::make_unique<ResultsWriter>(directory, blank, provenance_of(c),
                                         c.output.frames + first_and_last);
}

std::unique_ptr<HistoryWriter> open_history(const std::filesystem::path& directory,
                                            const std::vector<std::string>& columns, const Record& record)
{
  const std::filesystem::path path = directory / "history.csv";
  if (record.rows > 0) return std::make_unique<HistoryWriter>(path, columns, record.rows);
  return std::make_unique<HistoryWriter>(path, columns);
}

} // namespace towform
