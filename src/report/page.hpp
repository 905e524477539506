#pragma once
#include "report/plot.hpp"
#include "report/scene.hpp"
#include "report/verdict.hpp"

namespace towform {

/// All that a page shows.
struct PageContent {
  const RunRecord& run;
  const ResultsFrames& frames;  ///< for the provenance in the file's attributes
  const Scene* scene = nullptr; ///< null without the 3-D view
  std::vector<Finding> findings;
  std::vector<Plot> plots;
  std::vector<std::string> notes; ///< what was left out and why
};

/// The page, whole: style, view, data and all.
std::string page_html(const PageContent& content);

} // namespace towform
