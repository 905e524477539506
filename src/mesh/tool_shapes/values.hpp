#pragma once
#include "towform/tool_shapes.hpp"
#include <cassert>
#include <string_view>

namespace towform::shapes {

/// Values of a shape's parameters by name.
class Values {
public:
  Values(const std::vector<ShapeParameter>& parameters, const std::vector<double>& values)
      : parameters_(parameters), values_(values)
  {
  }
  double operator[](std::string_view name) const
  {
    std::size_t i = 0;
    while (i < parameters_.size() && parameters_[i].name != name) ++i;
    assert(i < parameters_.size());
    return values_[i];
  }

private:
  const std::vector<ShapeParameter>& parameters_;
  const std::vector<double>& values_;
};

SurfaceMesh build_double_dome(const std::string& part, const Values& values);
SurfaceMesh build_hemisphere(const std::string& part, const Values& values);
SurfaceMesh build_male_dome(const std::string& part, const Values& values);

} // namespace towform::shapes
