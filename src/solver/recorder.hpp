#pragma once
#include "solver/energy.hpp"
#include "solver/gates.hpp"
#include "solver/measure.hpp"
#include "solver/model.hpp"
#include "solver/progress.hpp"
#include "solver/run_state.hpp"
#include "towform/results.hpp"
#include <memory>
#include <optional>

namespace towform {

/// Writes what a run leaves behind and keeps the figures of its summary.
class Recorder {
public:
  /// `record` is what is remembered, of a run that starts or goes on; it must outlive the recorder. Files of
  /// a run that goes on are cut back to what it says was written.
  Recorder(const Case& c, const Model& model, const std::filesystem::path& directory, Record& record);

  /// A row of the history; judges the run against the case's gates (RunStopped).
  void history(const System& s);
  /// A frame of the results and a line for the user.
  void frame(const System& s, Progress& progress);
  /// Leaves the state of a run that was stopped, as far as it can be written.
  void last_frame(const System& s, Progress& progress);
  /// Called after every step, cheap.
  void watch(const System& s, double dt);

  [[nodiscard]] Summary& summary() { return record_.summary; }
  /// Closes the results and writes summary.json.
  void finish();

private:
  void measure(const System& s);

  const Case& case_;
  const Model& model_;
  Record& record_;
  std::filesystem::path directory_;
  DrawInGauge gauge_;
  std::unique_ptr<ResultsWriter> results_;
  std::unique_ptr<HistoryWriter> history_;
  std::optional<CurvatureOperator> own_curvature_; ///< of a sheet that does not resist bending
  Energies energies_;
  FieldExtremes extremes_;
  DrawIn draw_in_;
};

} // namespace towform
