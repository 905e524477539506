#include "element/quadrilateral.hpp"
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace towform {

namespace {

constexpr std::array<double, 4> corner_xi{-1.0, 1.0, 1.0, -1.0}, corner_eta{-1.0, -1.0, 1.0, 1.0};
const double gauss = 1.0 / std::sqrt(3.0);

QuadrilateralPoint point_at(double xi, double eta, const Quadrilateral& q, const QuadrilateralGrid& grid)
{
  std::array<double, 4> by_xi{}, by_eta{};
  double x_xi = 0.0, x_eta = 0.0, y_xi = 0.0, y_eta = 0.0;
  for (int c = 0; c < 4; ++c) {
    by_xi[c] = 0.25 * corner_xi[c] * (1.0 + corner_eta[c] * eta);
    by_eta[c] = 0.25 * corner_eta[c] * (1.0 + corner_xi[c] * xi);
    const Vec3& x = grid.points[q[c]];
    x_xi += by_xi[c] * x.x;
    x_eta += by_eta[c] * x.x;
    y_xi += by_xi[c] * x.y;
    y_eta += by_eta[c] * x.y;
  }
  QuadrilateralPoint p{};
  p.area = x_xi * y_eta - x_eta * y_xi; // the points' weights are 1
  for (int c = 0; c < 4; ++c) {
    const Vec3 gradient{(y_eta * by_xi[c] - y_xi * by_eta[c]) / p.area,
                        (x_xi * by_eta[c] - x_eta * by_xi[c]) / p.area, 0.0};
    p.warp[c] = dot(gradient, grid.warp);
    p.weft[c] = dot(gradient, grid.weft);
  }
  return p;
}

} // namespace

StructuralNet QuadrilateralPoint::net(const Quadrilateral& q, std::span<const Vec3> position) const
{
  Vec3 a1, a2;
  for (int c = 0; c < 4; ++c) {
    a1 += warp[c] * position[q[c]];
    a2 += weft[c] * position[q[c]];
  }
  return {{a1.x, a1.y, a1.z}, {a2.x, a2.y, a2.z}};
}

QuadrilateralMembrane::QuadrilateralMembrane(const QuadrilateralGrid& grid, const YarnLaw& yarn_law,
                                             FabricLaw fabric_law)
    : elements(grid.elements), reference_sine(dot(grid.warp, grid.weft)), thickness(grid.thickness),
      yarn(yarn_law), law(std::move(fabric_law))
{
  points.reserve(points_per_element * elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (int c = 0; c < 4; ++c) { // each point beside its corner
      points.push_back(point_at(gauss * corner_xi[c], gauss * corner_eta[c], elements[e], grid));
      if (!(points.back().area > 0.0))
        throw std::invalid_argument("quadrilateral " + std::to_string(e) + " is turned over or not convex");
    }
}

bool QuadrilateralMembrane::response(std::size_t element, std::span<const Vec3> position, const Step& step,
                                     Vector& force, Matrix* tangent) const
{
  const Quadrilateral& q = elements[element];
  const double reference_angle = std::asin(reference_sine);
  force.setZero();
  if (tangent) tangent->setZero();
  for (std::size_t k = points_per_element * element; k < points_per_element * (element + 1); ++k) {
    const QuadrilateralPoint& point = points[k];
    const StructuralNet net = point.net(q, position);
    const double cosine = std::sqrt(1.0 - net.sine * net.sine);
    if (!(cosine > 0.0)) return false;

    ShearPoint& after = step.after[k];
    after = step.before[k];
    const auto [lost, slope] = std::visit(
        [&](const auto& l) {
          const double power = l.update(after, std::asin(net.sine) - reference_angle, step.dt);
          return std::pair(power, l.tangent(step.before[k], after, step.dt));
        },
        law);
    step.lost[k] = lost;

    const double strain1 = net.lambda1 - 1.0, strain2 = net.lambda2 - 1.0;
    const StructuralNet::Forces forces{yarn.tension(strain1), yarn.tension(strain2), after.force};
    const Eigen::Vector3d p1 = point.area * net.warp_stress(forces),
                          p2 = point.area * net.weft_stress(forces);
    for (int c = 0; c < 4; ++c) force.segment<3>(3 * c) += point.warp[c] * p1 + point.weft[c] * p2;
    if (!tangent) continue;

    const auto h = net.tangent(forces, {yarn.slope(strain1), yarn.slope(strain2), slope / cosine});
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        tangent->block<3, 3>(3 * a, 3 * b) +=
            point.area * (point.warp[a] * point.warp[b] * h.topLeftCorner<3, 3>() +
                          point.warp[a] * point.weft[b] * h.topRightCorner<3, 3>() +
                          point.weft[a] * point.warp[b] * h.bottomLeftCorner<3, 3>() +
                          point.weft[a] * point.weft[b] * h.bottomRightCorner<3, 3>());
  }
  return force.allFinite();
}

double QuadrilateralMembrane::yarn_energy(std::span<const Vec3> position) const
{
  double sum = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const StructuralNet net = points[k].net(elements[k / points_per_element], position);
    sum += points[k].area * (yarn.energy(net.lambda1 - 1.0) + yarn.energy(net.lambda2 - 1.0));
  }
  return sum;
}

} // namespace towform
