#pragma once

namespace towform {

/// A facet and its distance from some point, rounded down: a bound [m].
struct NearFacet {
  int facet = -1;
  float distance = 0.0F;
};

} // namespace towform
