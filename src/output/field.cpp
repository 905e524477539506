#include "output/field.hpp"

namespace towform {

namespace {

// Arrays go to HDF5 as rows of numbers.
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(std::array<double, 2>) == 2 * sizeof(double));

template <auto Member>
Field::Values values_of(const Frame& frame)
{
  const auto& array = frame.*Member;
  return {array.data(), array.size()};
}

using enum Field::Centre;
using enum Field::Number;

// Positions are differenced (strains, gaps), so they keep all their bits; seven digits are plenty to look at
// the rest.
constexpr Field table[] = {
    {"position", "m", node, 3, float64, values_of<&Frame::position>},
    {"velocity", "m/s", node, 3, float32, values_of<&Frame::velocity>},
    {"contact_pressure", "Pa", node, 1, float32, values_of<&Frame::contact_pressure>},
    {"clearance", "m", node, 1, float32, values_of<&Frame::clearance>, true},
    {"shear_angle", "deg", element, 1, float32, values_of<&Frame::shear_angle>},
    {"shear_rate", "rad/s", element, 1, float32, values_of<&Frame::shear_rate>},
    {"curve_index", "1", element, 1, int32, values_of<&Frame::curve_index>},
    {"curve_position", "1", element, 1, float32, values_of<&Frame::curve_position>},
    {"shear_force", "N/m", element, 1, float32, values_of<&Frame::shear_force>},
    {"fibre_1", "1", element, 3, float32, values_of<&Frame::fibre_1>},
    {"fibre_2", "1", element, 3, float32, values_of<&Frame::fibre_2>},
    {"fibre_strain", "1", element, 2, float32, values_of<&Frame::fibre_strain>},
    {"curvature", "1/m", element, 2, float32, values_of<&Frame::curvature>},
    {"thickness", "m", element, 1, float32, values_of<&Frame::thickness>},
    {"temperature", "K", element, 1, float32, values_of<&Frame::temperature>},
};

} // namespace

std::span<const Field> fields() { return table; }

} // namespace towform
