#include "towform/preview.hpp"
#include "output/output_directory.hpp"
#include "solver/recorder.hpp"
#include "solver/statics_recorder.hpp"

namespace towform {

namespace {

/// One row, one frame and a summary of a system that has not moved.
template <class RecorderOf, class State>
void record_start(RecorderOf& recorder, const State& state, Record& record, Progress& progress)
{
  recorder.history(state);
  recorder.frame(state, progress);
  record.summary.status = "preview";
  record.summary.message = "preview: nothing has been computed";
  recorder.finish();
}

} // namespace

void write_preview(const Case& c, const std::filesystem::path& directory, bool force)
{
  if (!force) refuse_earlier_results(directory);
  Record record;
  const auto with_files = [&](auto make_recorder, const auto& state) {
    const OutputDirectory held(directory);
    if (!force) refuse_earlier_results(directory);
    Progress progress(directory, ProgressStyle::quiet);
    auto recorder = make_recorder();
    record_start(recorder, state, record, progress);
  };
  if (c.solver == SolverKind::implicit) {
    const StaticsCase problem = build_statics(c);
    with_files([&] { return StaticsRecorder(c, problem, directory, record); }, start(problem.model));
  } else {
    const Model model = build_model(c);
    with_files([&] { return Recorder(c, model, ShownCurvature(model), directory, record); }, start(model));
  }
}

} // namespace towform
