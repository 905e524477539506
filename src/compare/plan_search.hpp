#pragma once
#include "towform/surface_mesh.hpp"
#include <span>
#include <vector>

namespace towform {

/// Finds the triangles that lie over or under a point of the plan (x, y).
class PlanSearch {
public:
  /// The places and triangles have to outlive the search.
  PlanSearch(std::span<const Vec3> places, std::span<const Triangle> triangles);

  /// A triangle over the point and its height there.
  struct Holder {
    int element = 0;
    double z = 0.0; ///< [m]
  };
  /// All of them, edges included (within 1e-9 of a triangle's size), the highest first; triangles that stand
  /// upright hold no point.
  [[nodiscard]] std::vector<Holder> holders(Vec2 point) const;

private:
  [[nodiscard]] std::size_t cell(double x, double y) const;

  std::span<const Vec3> places_;
  std::span<const Triangle> triangles_;
  Vec2 low_, high_;
  double width_ = 1.0; ///< of a cell [m]
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> elements_; ///< of every cell: triangles whose boxes touch it
};

} // namespace towform
