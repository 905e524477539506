#pragma once
#include "towform/case.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace towform {

/// When a run stops before its end: after the step that is under way, with a checkpoint.
struct RunControls {
  const volatile std::sig_atomic_t* signal = nullptr; ///< number of a signal that has come, 0 before
  double max_wall = 0.0;                              ///< wall time of this session [s]; 0: no limit
  std::int64_t max_steps = 0;                         ///< steps of this session; 0: no limit
};

struct RunOptions {
  std::filesystem::path directory; ///< made when missing
  int threads = 0;                 ///< 0: as many as the machine has
  bool quiet = false;              ///< nothing but errors
  bool force = false;              ///< replace the results of an earlier run
  RunControls controls{};
  bool json_progress = false;            ///< a line of JSON at each output in place of words
  std::shared_ptr<const ShearLaw> law{}; ///< of the program, to `resume` a run that it was used in
};

/// How a run ended: everything computed until then is on disk and readable.
struct RunOutcome {
  ExitCode code = ExitCode::done;
  Summary summary;
};

/// Runs a case into a directory: results.h5, results.xdmf, history.csv, summary.json, case.resolved.toml, and
/// checkpoint.h5 until it is done. Input is checked whole before anything is written. Throws InputError and
/// FileError, the latter also when the directory holds earlier results or is in use; a gate that stops the
/// run and an interruption are outcomes, not exceptions.
RunOutcome run(const Case& c, const RunOptions& options);

/// Goes on with the run in a directory from its newest checkpoint that is whole, to the same bits as if it
/// had never stopped, on any number of threads (`force` means nothing). A run that is done is an outcome as
/// it is. Throws CheckpointError when there is none or the case, its law or one of its files has changed.
RunOutcome resume(const RunOptions& options);

/// What `run` would do, in words: elements, steps, tools, yarns. Throws InputError as `run` does.
std::string describe_run(const Case& c);

} // namespace towform
