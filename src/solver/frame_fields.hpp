#pragma once
#include "solver/model.hpp"
#include "towform/results.hpp"
#include <string_view>

namespace towform {

/// A field of the sheet's state at t_n by its name in the results, in a frame that has nothing else. An element's curvature
/// along a yarn family is that of its corners which is largest in size, so that folds as short as an element are seen.
Frame frame_field(const Model& model, const System& s, const CurvatureOperator& curvature, std::string_view name);

} // namespace towform
