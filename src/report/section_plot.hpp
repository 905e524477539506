#pragma once
#include "report/plot.hpp"
#include "report/run_record.hpp"

namespace towform {

/// Shear along the case's section (report.from, report.to) of the formed sheet or, when the case names a
/// reference, whatever the reference's columns say is to be compared, with its points over the sheet's own.
/// `notes` gets why a reference could not be drawn; the section is then drawn without it.
Plot section_plot(const RunRecord& run, std::vector<std::string>& notes);

} // namespace towform
