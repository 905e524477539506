#include "report_command.hpp"
#include "towform/report.hpp"
#include <fmt/format.h>

namespace towform {

void add_report_command(CLI::App& app)
{
  CLI::App* command = app.add_subcommand(
      "report",
      "write DIR/report.html: one page with the formed sheet in 3-D, plots, verdict and provenance");
  auto directory = std::make_shared<std::string>();
  auto options = std::make_shared<ReportOptions>();
  command->add_option("directory", *directory, "directory of a run's results, done or still going on")
      ->required()
      ->type_name("DIR");
  command
      ->add_option_function<double>(
          "--max-size", [options](double mb) { options->limit = static_cast<std::size_t>(1e6 * mb); },
          "of the page's data [MB]: frames are left out until it fits [14]")
      ->type_name("MB")
      ->check(CLI::Range(0.1, 1000.0));
  command
      ->add_option("--wait", options->wait,
                   "seconds to wait for results that a run is writing and that cannot be read yet [10]")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber);
  command->callback([directory, options] {
    const ReportOutcome outcome = write_report(*directory, *options);
    for (const std::string& note : outcome.notes) fmt::print("{}\n", note);
    fmt::print("wrote {}, {:.1f} MB\n", outcome.path.string(), 1e-6 * static_cast<double>(outcome.bytes));
  });
}

} // namespace towform
