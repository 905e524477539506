#include "towform/report.hpp"
#include "output/text_file.hpp"
#include "output/while_written.hpp"
#include "report/page.hpp"
#include "report/resources.hpp"
#include "report/run_plots.hpp"
#include <optional>

namespace towform {

namespace {

ReportOutcome report_now(const std::filesystem::path& directory, const ReportOptions& options)
{
  const RunRecord run = read_run(directory);
  const ResultsFrames frames(directory / "results.h5");
  std::optional<Scene> scene;
  PageContent content{run, frames, nullptr, verdict(run), {}, run.gaps};
  content.plots = run_plots(run, content.notes);
  if (!resources::viewer().empty()) {
    scene = make_scene(run, frames, options.limit);
    content.notes.insert(content.notes.end(), scene->notes.begin(), scene->notes.end());
    content.scene = &*scene;
  } else {
    content.notes.emplace_back("the 3-D view: this towform was built without Node, which bundles it");
  }
  const std::string page = page_html(content);
  ReportOutcome outcome{directory / "report.html", page.size(), content.notes};
  replace_file(outcome.path, page);
  return outcome;
}

} // namespace

ReportOutcome write_report(const std::filesystem::path& directory, const ReportOptions& options)
{
  return read_while_written(directory, options.wait, [&] { return report_now(directory, options); });
}

} // namespace towform
