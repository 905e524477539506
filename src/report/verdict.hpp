#pragma once
#include "report/run_record.hpp"

namespace towform {

/// One thing to know about a run before its pictures are believed.
struct Finding {
  enum class Grade { good, watch, bad };
  Grade grade = Grade::good;
  std::string text; ///< a sentence or two, with the figure and its limit
};

/// How the run ended, shear against the locking angle, the case's gates, and what makes the answer doubtful:
/// inertia, yarns that stretch, compression that hides wrinkles.
std::vector<Finding> verdict(const RunRecord& run);

/// The worst grade of them.
Finding::Grade worst(const std::vector<Finding>& findings);

/// What the run itself warned of, from its log.
std::vector<std::string> warnings_of(const std::string& log);

} // namespace towform
