#pragma once
#include "solver/energy.hpp"
#include "solver/progress.hpp"
#include "solver/run_state.hpp"
#include "solver/statics_model.hpp"
#include "towform/results.hpp"
#include <memory>

namespace towform {

/// Fields of an equilibrium. Results files know triangles: every quadrilateral is written as two (2e and
/// 2e + 1), both with the mean of its four points.
Frame make_frame(const StaticsCase& problem, double temperature, const StaticsState& s);

/// The energy account of an equilibrium; without kinetic, contact, friction and damping.
Energies energy_account(const StaticsModel& model, const StaticsState& s);

/// Writes what a quasi-static run leaves behind and keeps the figures of its summary.
class StaticsRecorder {
public:
  /// `record` as for a Recorder.
  StaticsRecorder(const Case& c, const StaticsCase& problem, const std::filesystem::path& directory,
                  Record& record);

  /// Called at every equilibrium.
  void watch(const StaticsState& s, const NewtonReport& report);
  /// A row of the history; judges the run against the case's gates (RunStopped).
  void history(const StaticsState& s);
  /// A frame of the results and a line for the user.
  void frame(const StaticsState& s, Progress& progress);

  [[nodiscard]] Summary& summary() { return record_.summary; }
  /// Closes the results and writes summary.json.
  void finish();

private:
  void measure(const StaticsState& s);
  void check_gates(const StaticsState& s) const;

  const Case& case_;
  const StaticsCase& problem_;
  Record& record_;
  std::filesystem::path directory_;
  std::size_t central_; ///< the element nearest to the middle
  std::unique_ptr<ResultsWriter> results_;
  std::unique_ptr<HistoryWriter> history_;
  Energies energies_;
  int most_strained_ = 0;
};

} // namespace towform
