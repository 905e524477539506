#pragma once
#include "towform/state.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace towform {

/// What a node's curvatures are made of, by points of the whole sheet. Terms are in an order that depends on the weights alone.
struct CurvaturePatch {
  static constexpr double rounding = 1e-11; ///< of the largest weight

  std::vector<int> points;
  std::vector<YarnPair> weights; ///< [1/m^2]
  std::vector<std::int64_t> key; ///< the weights but for rounding, warp and weft of each; 0 for none
  std::array<int, 4> ends;       ///< of two chords

  CurvaturePatch() = default;
  CurvaturePatch(const std::vector<int>& its_points, const std::vector<double>& warp, const std::vector<double>& weft,
                 const std::array<int, 4>& its_ends);
};

} // namespace towform
