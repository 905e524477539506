#pragma once
#include "element/membrane.hpp"
#include <span>
#include <vector>

namespace towform {

/// What the mean strains of strips see of the nodes: their displacements along one of the yarns.
class StripParts {
public:
  struct Part {
    int component;   ///< 2 node + family
    double gradient; ///< of the mean strain [1/m]
  };

  /// Of m triangles with their yarn gradients and areas [m^2].
  StripParts(std::span<const Triangle> triangles, std::span<const YarnGradients> gradients, std::span<const double> area,
             const YarnStrips& strips);
  explicit StripParts(const Membrane& membrane);

  [[nodiscard]] std::span<const Part> of(std::size_t strip) const
  {
    return {parts_.data() + first_[strip], parts_.data() + first_[strip + 1]};
  }

private:
  std::vector<Part> parts_; // by strip
  std::vector<int> first_;
};

} // namespace towform
