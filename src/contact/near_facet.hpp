#pragma once

namespace towform {

/// A facet and its distance from some point [m].
struct NearFacet {
  int facet = -1;
  double distance = 0.0;
};

} // namespace towform
