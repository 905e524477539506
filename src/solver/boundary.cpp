#include "solver/boundary.hpp"
#include "material/shear_resistance.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace towform {

namespace {

using Edge = BoundaryParameters::Edge;
using std::numbers::sqrt2;

/// The sides of the box round the flat blank.
struct Sides {
  Vec2 low, high;
  double tolerance = 0.0;

  Sides(const Blank& blank, bool imported) : low{blank.mesh.points[0].x, blank.mesh.points[0].y}, high(low)
  {
    for (const Vec3& p : blank.mesh.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    tolerance = (imported ? 1e-6 : 1e-9) * std::max(high.x - low.x, high.y - low.y);
  }
  [[nodiscard]] bool has(Edge edge, const Vec3& x) const
  {
    const double beyond = edge == Edge::left     ? x.x - low.x
                          : edge == Edge::right  ? high.x - x.x
                          : edge == Edge::bottom ? x.y - low.y
                                                 : high.y - x.y;
    return beyond <= tolerance;
  }
};

double whole_over_modelled(Edge edge, Symmetry symmetry)
{
  const bool upright = edge == Edge::left || edge == Edge::right;
  const bool halved = symmetry == Symmetry::quarter || symmetry == (upright ? Symmetry::y : Symmetry::x);
  return halved ? 2.0 : 1.0;
}

/// Cosine of the half angle between a frame's arms at its fixed corner (Eq. 13).
double half_angle_cosine(double displacement, double arm) { return 1.0 / sqrt2 + displacement / (2.0 * arm); }

/// Looks along the motion, closely enough for any table: a frame must not collapse.
void check_frame(const Boundary& frame, double end)
{
  constexpr int looks = 1000;
  for (int i = 0; i <= looks; ++i) {
    const double cosine = half_angle_cosine(frame.motion->displacement(end * i / looks), frame.arm);
    const double angle = 0.5 * std::numbers::pi - 2.0 * std::acos(std::clamp(cosine, -1.0, 1.0));
    if (std::abs(angle) > ShearResistance::max_angle)
      throw std::invalid_argument(fmt::format(
          "boundary.{}: the frame shears the sheet beyond {:.0f} degrees; a displacement within {:.4g} mm "
          "does not",
          frame.name, ShearResistance::max_angle * 180.0 / std::numbers::pi,
          2e3 * frame.arm *
              (std::cos(0.25 * std::numbers::pi - 0.5 * ShearResistance::max_angle) - 1.0 / sqrt2)));
  }
}

} // namespace

Boundary make_boundary(const BoundaryParameters& p, const BlankParameters& flat, const Blank& blank,
                       double end)
{
  Boundary b;
  b.name = p.name;
  b.motion = p.motion;
  const bool frame = p.kind == BoundaryParameters::Kind::picture_frame;
  if (frame)
    b.arm = flat.size.x;
  else
    b.whole_edge = whole_over_modelled(p.edge, flat.symmetry);
  if (p.motion && !frame) b.direction = unit_vector(p.motion->axis);
  const Sides sides(blank, !flat.mesh.empty());
  for (std::size_t n = 0; n < blank.mesh.points.size(); ++n) {
    const Vec3& x = blank.mesh.points[n];
    const auto on = [&](Edge edge) { return sides.has(edge, x); };
    if (frame ? on(Edge::left) || on(Edge::right) || on(Edge::bottom) || on(Edge::top) : on(p.edge)) {
      b.nodes.push_back(static_cast<int>(n));
      b.start.push_back(frame ? Vec3{x.x / b.arm + 0.5, x.y / b.arm + 0.5, 0.0} : x);
    }
  }
  if (b.nodes.size() < 2) // of an imported blank only
    throw std::invalid_argument(fmt::format(
        "boundary.{}: the mesh has one node only on that side of its bounding box; a grip needs a "
        "straight edge there",
        p.name));
  if (frame && b.motion) check_frame(b, end);
  return b;
}

Boundary::Place Boundary::place(std::size_t i, double displacement) const
{
  const Vec3& at = start[i];
  if (arm == 0.0) return {at + displacement * direction, direction};
  // Arms at 45 degrees -+ beta against x from the fixed corner, cos beta = c: (c + s, c - s)/sqrt 2 and its
  // mirror image.
  const double c = half_angle_cosine(displacement, arm), s = std::sqrt(1.0 - c * c);
  const double along = (c + s) / sqrt2, across = (c - s) / sqrt2;
  const double c_slope = 0.5 / arm, s_slope = -c / s * c_slope;
  const double along_slope = (c_slope + s_slope) / sqrt2, across_slope = (c_slope - s_slope) / sqrt2;
  const Vec3 corner{-0.5 * arm, -0.5 * arm, 0.0};
  return {corner + arm * Vec3{at.x * along + at.y * across, at.x * across + at.y * along, 0.0},
          arm *
              Vec3{at.x * along_slope + at.y * across_slope, at.x * across_slope + at.y * along_slope, 0.0}};
}

double advance(const Boundary& boundary, BoundaryState& b, State& s, double time, double dt)
{
  const double before = b.displacement;
  if (boundary.motion) b.displacement = boundary.motion->displacement(time + dt);
  b.moved = b.displacement - before;
  b.work += 0.5 * b.force * b.moved; // the other half once the force at the end is known
  double fastest = 0.0;
  for (std::size_t i = 0; i < boundary.nodes.size(); ++i) {
    const int n = boundary.nodes[i];
    const Vec3 from = boundary.place(i, before).position, to = boundary.place(i, b.displacement).position;
    s.position[n] = to;
    s.velocity[n] = (1.0 / dt) * (to - from);
    if (!s.mass_damping.empty()) s.mass_damping[n] = 0.0;
    fastest = std::max(fastest, norm(s.velocity[n]));
  }
  return fastest;
}

void take_reaction(const Boundary& boundary, BoundaryState& b, State& s)
{
  b.force = 0.0;
  for (std::size_t i = 0; i < boundary.nodes.size(); ++i) {
    Vec3& force = s.force[boundary.nodes[i]];
    b.force -= dot(force, boundary.place(i, b.displacement).slope);
    force = {};
  }
  b.work += 0.5 * b.force * b.moved;
}

double kinetic_energy(const Boundary& boundary, const State& s, std::span<const double> mass)
{
  double sum = 0.0;
  for (const int n : boundary.nodes) sum += 0.5 * mass[n] * norm_squared(s.velocity[n]);
  return sum;
}

} // namespace towform
