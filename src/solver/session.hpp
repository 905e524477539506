#pragma once
#include "output/output_directory.hpp"
#include "solver/checkpoint.hpp"
#include "solver/interruption.hpp"
#include "solver/progress.hpp"
#include "solver/run_state.hpp"
#include "towform/run.hpp"
#include <chrono>
#include <memory>

namespace towform {

/// One start of the program on a run, new or gone on with: its directory, checkpoints and interruptions.
class Session {
public:
  /// A new run.
  Session(const Case& c, const RunOptions& options);
  /// One that goes on; holds its directory from here on. Throws CheckpointError, FileError.
  explicit Session(const RunOptions& options);

  [[nodiscard]] const Case& the_case() const { return c_; }
  [[nodiscard]] bool resumes() const { return resumes_; }
  [[nodiscard]] const std::filesystem::path& directory() const { return options_.directory; }

  /// Takes the directory for a new run, or reads its checkpoint. To be called once the model is built, so
  /// that nothing is written for a case that is no good. `state` visits all that a checkpoint holds.
  void begin(Record& record, std::function<void(FieldVisitor&)> state);
  /// The lines and log of the run; after `begin`.
  [[nodiscard]] Progress& progress() { return *progress_; }

  /// Between two steps: writes a checkpoint when one is due. True when the run is to stop.
  bool stops_after(std::int64_t step, double time);
  /// What to tell the user then.
  [[nodiscard]] std::string stop_message(std::int64_t step, double time) const;

  /// Runs `write`; when a file cannot be written, leaves a checkpoint of the state before it, if it can, and
  /// throws FileError with what can be done.
  void output(const std::function<void()>& write);

  /// Sums the wall time of this and earlier sessions into the record, and puts `stepping` of it over the
  /// elements' steps.
  void account(double stepping);
  /// A run that is done needs its checkpoints no longer.
  void done() { remove_checkpoints(options_.directory); }

private:
  void save();

  Case c_;
  RunOptions options_;
  CheckpointOrigin origin_;
  bool resumes_;
  std::unique_ptr<OutputDirectory> held_;
  std::unique_ptr<Progress> progress_;
  std::unique_ptr<Interruption> interruption_;
  std::function<void(FieldVisitor&)> state_;
  Record* record_ = nullptr;
  std::chrono::steady_clock::time_point start_;
  double wall_before_ = 0.0;
};

} // namespace towform
