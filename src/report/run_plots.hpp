#pragma once
#include "report/plot.hpp"
#include "report/run_record.hpp"

namespace towform {

/// The few curves that tell whether to believe a run: forces against stroke, energies, their error, draw-in,
/// how shear is spread, and shear along a section with the reference's points over it. A plot that has
/// nothing to show is left out; `notes` gets why the reference could not be drawn.
std::vector<Plot> run_plots(const RunRecord& run, std::vector<std::string>& notes);

} // namespace towform
