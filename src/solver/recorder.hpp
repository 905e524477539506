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

/// The curvatures of the frames: those that a sheet bends by, or its own where it does not resist bending. Takes more memory while
/// it is made than afterwards.
class ShownCurvature {
public:
  explicit ShownCurvature(const Model& model)
  {
    if (model.bending.empty())
      own_.emplace(model.blank, model.clamped, 0);
    else
      of_bending_ = &model.bending.front().curvature;
  }
  [[nodiscard]] const CurvatureOperator& get() const { return own_ ? *own_ : *of_bending_; }

private:
  std::optional<CurvatureOperator> own_;
  const CurvatureOperator* of_bending_ = nullptr;
};

/// Writes what a run leaves behind and keeps the figures of its summary.
class Recorder {
public:
  /// `model` and `record` must outlive the recorder. `record` is what is remembered, of a run that starts or goes on; files of
  /// a run that goes on are cut back to what it says was written.
  Recorder(const Case& c, const Model& model, ShownCurvature curvature, const std::filesystem::path& directory, Record& record);

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
  ShownCurvature curvature_;
  Record& record_;
  std::filesystem::path directory_;
  DrawInGauge gauge_;
  std::unique_ptr<ResultsWriter> results_;
  std::unique_ptr<HistoryWriter> history_;
  Energies energies_;
  FieldExtremes extremes_;
  DrawIn draw_in_;
};

} // namespace towform
