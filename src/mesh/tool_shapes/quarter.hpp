#pragma once
#include "towform/surface_mesh.hpp"
#include <functional>
#include <span>

/// Tools as a sequence of rings: the quarter x >= 0, y >= 0 is lofted ring by ring and mirrored.
///
/// A ring runs from the plane x = 0 to the plane y = 0. Its parameter u is 0 to 1 over the part between the
/// dome centres (absent when they coincide) and 1 to 2 over the quarter turn round the dome centre.
namespace towform::shapes {

using Curve = std::function<Vec3(double u)>;

/// Something for each of the two parts of a ring; a `middle` of zero: there is none.
template <class T>
struct Along {
  T middle{};
  T dome{};
};

struct Ring {
  std::vector<int> nodes;
  std::size_t join = 0;   ///< where u = 1
  std::size_t corner = 0; ///< of a ring near the rectangular rim; 0: none
};

/// How many intervals of at most `spacing` [m] each part of a ring needs.
Along<int> intervals(const Curve& curve, Along<double> spacing);

class Quarter {
public:
  Ring ring(const Curve& curve, Along<int> intervals);
  Ring ring(std::vector<Vec3> points, std::size_t join, std::size_t corner = 0);

  /// Triangles between neighbouring rings; the normal is (along the ring) x (to the next ring).
  void loft(const std::vector<Ring>& rings);
  void loft(const Ring& first, const Ring& second);

  /// All four quarters; nodes on the planes of symmetry are shared, the others equal to the bit but for sign.
  [[nodiscard]] SurfaceMesh mirrored() const;

private:
  void zip(std::span<const int> first, std::span<const int> second);

  SurfaceMesh mesh_;
};

} // namespace towform::shapes
