#pragma once
#include "element/quadrilateral_grid.hpp"
#include "element/structural_net.hpp"
#include "element/yarn.hpp"
#include "material/fabric_law.hpp"
#include "towform/state.hpp"
#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace towform {

/// An integration point of a quadrilateral: F f01 = sum_c warp[c] x_c, with warp[c] = grad N_c . f01 [1/m],
/// likewise weft.
struct QuadrilateralPoint {
  std::array<double, 4> warp, weft;
  double area; ///< reference area it stands for [m^2]

  [[nodiscard]] StructuralNet net(const Quadrilateral& q, std::span<const Vec3> position) const;
};

/// Four-node membranes of one ply, total Lagrangian, 2 x 2 Gauss points: for the implicit solver. Bilinear
/// shape functions and full integration: no strain pattern is without stiffness, and any linear field is
/// exact on any quadrilateral.
struct QuadrilateralMembrane {
  static constexpr int points_per_element = 4;
  using Vector = Eigen::Matrix<double, 12, 1>; ///< x, y, z of corner 0, of corner 1, ...
  using Matrix = Eigen::Matrix<double, 12, 12>;

  std::vector<Quadrilateral> elements;    ///< m
  std::vector<QuadrilateralPoint> points; ///< 4m, those of an element together
  double reference_sine = 0.0;            ///< f01 . f02
  double thickness = 0.0;                 ///< [m]
  YarnLaw yarn;
  FabricLaw law;

  /// Throws std::invalid_argument naming an element that is turned over or not convex.
  QuadrilateralMembrane(const QuadrilateralGrid& grid, const YarnLaw& yarn_law, FabricLaw fabric_law);

  /// Where an update of the law's histories starts and ends.
  struct Step {
    double dt;                          ///< [s]
    std::span<const ShearPoint> before; ///< 4m, at the last equilibrium
    std::span<ShearPoint> after;        ///< 4m, set
    std::span<double> lost;             ///< 4m, power dissipated over cos(theta) [W/m^2], set
  };

  /// Nodal forces of the element [N] and, if wanted, their derivative by the nodal positions [N/m],
  /// the law's consistent tangent included. False when a point has turned over: the forces then mean
  /// nothing.
  bool response(std::size_t element, std::span<const Vec3> position, const Step& step, Vector& force,
                Matrix* tangent) const;

  /// Elastic energy of all yarns [J].
  [[nodiscard]] double yarn_energy(std::span<const Vec3> position) const;
};

} // namespace towform
