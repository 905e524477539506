#pragma once
#include "solver/run_state.hpp"
#include "towform/case.hpp"
#include <memory>

namespace towform {

// The files that a run fills: made for one that starts, cut back for one that goes on to what its record says
// was written. Throw FileError.
std::unique_ptr<ResultsWriter> open_results(const Case& c, const std::filesystem::path& directory,
                                            const SurfaceMesh& blank, const Record& record);
std::unique_ptr<HistoryWriter> open_history(const std::filesystem::path& directory,
                                            const std::vector<std::string>& columns, const Record& record);

} // namespace towform
