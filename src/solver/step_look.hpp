#pragma once
#include "solver/model.hpp"

namespace towform {

/// The stable step of a run at present.
struct PresentStep {
  double step = 0.0; ///< never longer than the first [s]
  int element = 0;   ///< one of those that set it
};

/// Looks at the stable step. It follows the bound, which is quickly found; how far the limit lies above that is measured again, into
/// `last`, once the bound has moved on, or a node touches more tools than were counted of it: nodes that touch several are then
/// counted anew, those round them as well. Throws RunStopped where an element has collapsed.
PresentStep look_at_step(const Model& model, const StepBound& bound, System& s, StepLook& last);

} // namespace towform
