#pragma once
#include "solver/model.hpp"

namespace towform {

/// The stable step of a run at present, never longer than the first. It follows the bound, which is quickly found; how far the limit lies above that is measured again, into
/// `last`, once the bound has moved on, or a node touches more tools than were counted of it: nodes that touch several are then
/// counted anew, those round them as well. Throws RunStopped where an element has collapsed.
StableStep look_at_step(const Model& model, const StepBound& bound, System& s, StepLook& last);

} // namespace towform
