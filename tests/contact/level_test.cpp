#include "contact/level.hpp"
#include "contact/shapes.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

constexpr int squares = 20; // a side, of two facets each
constexpr double pitch = 2.5e-3, side = squares * pitch;

/// A level plate, whose points nearer to its middle than `half` are pressed up.
SurfaceMesh plate(double half)
{
  SurfaceMesh mesh;
  for (int j = 0; j <= squares; ++j)
    for (int i = 0; i <= squares; ++i) {
      const double x = pitch * i, y = pitch * j, from_middle = std::max(std::abs(x - 0.5 * side), std::abs(y - 0.5 * side));
      mesh.points.push_back({x, y, from_middle < half ? 1e-3 : 0.0});
    }
  test::add_squares(mesh, squares);
  return mesh;
}

TEST(LevelRoom, ReachesToTheEdgeOfAPlate)
{
  const ToolSurface surface(plate(0.0));
  constexpr double most = 9e-3;
  for (int facet = 0; facet < 2 * squares * squares; ++facet) {
    double exact = most;
    for (const Vec3& p : surface.tree().facet(facet).corner) exact = std::min({exact, p.x, p.y, side - p.x, side - p.y});
    EXPECT_NEAR(level_room(surface, facet, most), exact, 1e-15);
  }
}

TEST(LevelRoom, ReachesToWhereThePlateRises)
{
  // One point is up, and the six facets round it rise.
  const ToolSurface surface(plate(0.5 * pitch));
  const Vec3 middle{0.5 * side, 0.5 * side, 0.0};
  constexpr double p = pitch;
  constexpr std::array<Vec3, 6> round{{{p, 0, 0}, {p, p, 0}, {0, p, 0}, {-p, 0, 0}, {-p, -p, 0}, {0, -p, 0}}};
  constexpr int samples = 200;
  for (int facet = 0; facet < 2 * squares * squares; ++facet) {
    const Facet& f = surface.tree().facet(facet);
    const double room = level_room(surface, facet, side);
    if (f.normal.z < 1.0) {
      EXPECT_EQ(room, 0.0);
      continue;
    }
    double exact = side;
    for (const Vec3& c : f.corner) exact = std::min({exact, c.x, c.y, side - c.x, side - c.y});
    for (std::size_t k = 0; k < round.size(); ++k)
      for (int i = 0; i < samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const Vec3 point = middle + (1.0 - share) * round[k] + share * round[(k + 1) % round.size()];
        exact = std::min(exact, std::sqrt(nearest_on_facet(f, point).distance_squared));
      }
    EXPECT_NEAR(room, exact, pitch / samples) << facet;
  }
}

} // namespace
} // namespace towform
