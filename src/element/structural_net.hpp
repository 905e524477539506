#pragma once
#include <Eigen/Core>
#include <cmath>

namespace towform {

/// The structural net at a point: two families of yarns, F f01 = a1 and F f02 = a2, and a force N that
/// resists their shear (physics: from the surface to a stress). Its first Piola-Kirchhoff resultant is
///   P = p1 x f01 + p2 x f02,   p1 = T1 f1 + N (f2 - s f1)/lambda1,   p2 = T2 f2 + N (f1 - s f2)/lambda2,
/// that is p_i = T_i dlambda_i/da_i + N ds/da_i.
class StructuralNet {
public:
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

  StructuralNet(const Vector& a1, const Vector& a2)
      : lambda1(a1.norm()), lambda2(a2.norm()), f1(a1 / lambda1), f2(a2 / lambda2), sine(f1.dot(f2)),
        shear1((f2 - sine * f1) / lambda1), shear2((f1 - sine * f2) / lambda2)
  {
  }

  double lambda1, lambda2; ///< stretches
  Vector f1, f2;           ///< unit, current warp and weft
  double sine;             ///< s = f1 . f2
  Vector shear1, shear2;   ///< ds/da1, ds/da2

  struct Forces {
    double tension1, tension2; ///< [N/m]
    double shear;              ///< N [N/m]
  };
  struct Slopes {
    double tension1, tension2; ///< dT/dlambda [N/m]
    double shear;              ///< dN/ds [N/m]
  };

  /// P f01 and P f02 [N/m].
  [[nodiscard]] Vector warp_stress(const Forces& f) const { return f.tension1 * f1 + f.shear * shear1; }
  [[nodiscard]] Vector weft_stress(const Forces& f) const { return f.tension2 * f2 + f.shear * shear2; }

  /// d(p1, p2)/d(a1, a2), 6 x 6, symmetric [N/m].
  [[nodiscard]] Eigen::Matrix<double, 6, 6> tangent(const Forces& f, const Slopes& k) const
  {
    Eigen::Matrix<double, 6, 6> h;
    h.topLeftCorner<3, 3>() = own_block(f1, lambda1, shear1, f.tension1, k.tension1, f.shear, k.shear);
    h.bottomRightCorner<3, 3>() = own_block(f2, lambda2, shear2, f.tension2, k.tension2, f.shear, k.shear);
    const Matrix mixed =
        (Matrix::Identity() - f1 * f1.transpose() - f2 * f2.transpose() + sine * f1 * f2.transpose()) /
        (lambda1 * lambda2); // d2s/da1 da2
    h.topRightCorner<3, 3>() = f.shear * mixed + k.shear * shear1 * shear2.transpose();
    h.bottomLeftCorner<3, 3>() = h.topRightCorner<3, 3>().transpose();
    return h;
  }

private:
  [[nodiscard]] Matrix own_block(const Vector& f, double lambda, const Vector& g, double tension,
                                 double tension_slope, double shear, double shear_slope) const
  {
    const Matrix along = f * f.transpose(), across = Matrix::Identity() - along;
    const Matrix turning = f * g.transpose();
    const Matrix second = // d2s/da da
        -(turning + turning.transpose()) / lambda - sine / (lambda * lambda) * across;
    return tension_slope * along + tension / lambda * across + shear * second +
           shear_slope * g * g.transpose();
  }
};

} // namespace towform
