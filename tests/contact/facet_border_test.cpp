#include "contact/one_contact.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

/// A prism of n sides round the x axis, its corners on a cylinder; without ends.
SurfaceMesh prism(double radius, double length, int n)
{
  SurfaceMesh mesh;
  for (int i = 0; i < n; ++i)
    for (const double x : {-0.5 * length, 0.5 * length})
      mesh.points.push_back({x, radius * std::cos(2 * M_PI * i / n), radius * std::sin(2 * M_PI * i / n)});
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, b + 1, a + 1});
    mesh.triangles.push_back({a, b, b + 1});
  }
  return mesh;
}

/// Largest tangential over radial force on a frictionless node that goes round the prism in contact.
double ripple(int sides)
{
  const double radius = 0.05, half = 0.5e-3;
  const Tool tool{"roll", ToolSurface(prism(radius, 0.2, sides)), 0.0, {}, {}, {0, 0, 1}, 0.0};
  const Contact contact(tool, 0, half, 0.1, 0.0, 1.0, 1e-6);
  ToolState tool_state;
  State s;
  s.velocity = {{}};
  double most = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double turn = 2e-3 * i;
    const Vec3 out{0.0, std::cos(turn), std::sin(turn)}, along{0.0, -std::sin(turn), std::cos(turn)};
    const double flat = radius * std::cos(M_PI / sides); // a little inside the flats' offset, everywhere
    s.position = {Vec3{0.013, 0.0, 0.0} + (flat + half - 1e-6) * out};
    s.force = {{}};
    ContactState c;
    start(contact, 1, c);
    test::contact_forces(contact, tool, tool_state, c, 1e-5, s, 1e-6);
    EXPECT_GT(dot(s.force[0], out), 0.0) << "at " << turn << ", " << sides << " sides";
    most = std::max(most, std::abs(dot(s.force[0], along)) / dot(s.force[0], out));
  }
  return most;
}

TEST(FacetBorder, ANodeThatCrossesItIsHeldByNoMoreThanTheFacetsSlope)
{
  // At a border the slope of the surface is pi/n against the cylinder's, on either side: that is all there
  // may be, so it falls with the facets' size, and no border acts as a step.
  double last = 1.0;
  for (const int sides : {16, 32, 64, 128}) {
    const double found = ripple(sides);
    EXPECT_LE(found, std::tan(M_PI / sides) * 1.02) << sides;
    EXPECT_LT(found, 0.6 * last) << sides;
    last = found;
  }
}

} // namespace
} // namespace towform
