#pragma once
#include "towform/case.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <filesystem>
#include <string>

namespace towform {

struct RunOptions {
  std::filesystem::path directory; ///< made when missing
  int threads = 0;                 ///< 0: as many as the machine has
  bool quiet = false;              ///< nothing but errors
};

/// How a run ended: everything computed until then is on disk and readable.
struct RunOutcome {
  ExitCode code = ExitCode::done;
  Summary summary;
};

/// Runs a case into a directory: results.h5, results.xdmf, history.csv, summary.json, case.resolved.toml.
/// Input is checked whole before anything is written. Throws InputError and FileError; a gate that stops the
/// run is an outcome, not an exception.
RunOutcome run(const Case& c, const RunOptions& options);

/// What `run` would do, in words: elements, steps, tools, yarns. Throws InputError as `run` does.
std::string describe_run(const Case& c);

} // namespace towform
