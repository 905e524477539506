#include "mesh/tool_shapes/dome_surface.hpp"
#include "mesh/tool_shapes_helpers.hpp"
#include <gtest/gtest.h>

/// How far the facets are from the exact surfaces, which are written here a second time, as implicit
/// functions.
namespace towform::tool_tests {
namespace {

/// The double dome punch: q(x, y, z) = 0 on it, positive outside; nothing shared with the builder.
struct Punch {
  double R = 65 * mm, waist = 55 * mm, D = 120 * mm, draft = 5 * degree;
  double apex = 0.0; ///< z

  /// Value and gradient. On the arc (rho/w)^2 + (1 - z/R)^2 - 1, on the wall rho/w less the profile's line.
  [[nodiscard]] std::pair<double, Vec3> q(const Vec3& p) const
  {
    const double x = std::abs(p.x), y = std::abs(p.y), z = p.z - apex;
    double a = std::hypot(x - D, y) / R; // half-width over w
    Vec3 a_p = (1.0 / (R * R * std::max(a, 1e-300))) * Vec3{x - D, y, 0.0};
    if (x < D) {
      const double k = std::numbers::pi / D;
      const double w = 0.5 * (R + waist) + 0.5 * (waist - R) * std::cos(k * x);
      const double w_x = -0.5 * (waist - R) * k * std::sin(k * x);
      a = y / w;
      a_p = {-y * w_x / (w * w), 1.0 / w, 0.0};
    }
    const double z_wall = R * (1.0 - std::sin(draft));
    double value = a * a + (1.0 - z / R) * (1.0 - z / R) - 1.0;
    Vec3 gradient = 2.0 * a * a_p + Vec3{0.0, 0.0, -2.0 * (1.0 - z / R) / R};
    if (z > z_wall) {
      const double scale = 2.0 * std::cos(draft);
      value = scale * (a - std::cos(draft) - std::tan(draft) * (z - z_wall) / R);
      gradient = scale * (a_p - Vec3{0.0, 0.0, std::tan(draft) / R});
    }
    gradient.x = std::copysign(1.0, p.x) * gradient.x;
    gradient.y = std::copysign(1.0, p.y) * gradient.y;
    return {value, gradient};
  }

  /// Nearest point, by going to the surface and then along it towards p.
  [[nodiscard]] Vec3 nearest(const Vec3& p) const
  {
    Vec3 foot = p;
    for (int i = 0; i < 200; ++i) {
      for (int k = 0; k < 8; ++k) {
        const auto [value, gradient] = q(foot);
        if (std::abs(value) < 1e-15) break;
        foot -= (value / norm_squared(gradient)) * gradient;
      }
      const Vec3 n = normalized(q(foot).second), to = p - foot;
      const Vec3 along = to - dot(to, n) * n;
      if (norm(along) < 1e-12) break;
      foot += along;
    }
    return foot;
  }
  [[nodiscard]] double distance(const Vec3& p) const { return norm(p - nearest(p)); }
};

/// The curve of the entry fillet's ball centres: distance `reach` from the closed punch, at height z.
struct BallCurve {
  Punch punch;
  double reach, z;

  /// Nearest point of the curve in plan, and the direction away from the punch there.
  [[nodiscard]] std::pair<Vec3, Vec3> nearest(const Vec3& p) const
  {
    Vec3 c{p.x, p.y, z}, out;
    for (int i = 0; i < 100; ++i) {
      for (int k = 0; k < 8; ++k) {
        const Vec3 from = c - punch.nearest(c);
        const double d = norm(from);
        const Vec3 gradient{from.x / d, from.y / d, 0.0};
        c -= ((d - reach) / norm_squared(gradient)) * gradient;
        out = normalized(gradient);
        if (std::abs(d - reach) < 1e-13) break;
      }
      const Vec3 to{p.x - c.x, p.y - c.y, 0.0};
      const Vec3 along = to - dot(to, out) * out;
      if (norm(along) < 1e-11) break;
      c += along;
    }
    return {c, out};
  }
};

// The closed punch's apex at half the sheet less the depth; the fillet's balls under the flange.
const Punch closed{.apex = 0.5 * mm - 60 * mm};
const BallCurve balls{closed, 3 * mm + 12 * mm, -0.5 * mm - 12 * mm};

bool first_quarter(const SurfaceMesh& m, const Triangle& t)
{
  return std::all_of(t.begin(), t.end(), [&](int i) { return m.points[i].x >= 0.0 && m.points[i].y >= 0.0; });
}

/// The farthest corner and the farthest sample of the facets that `wanted` picks.
struct Farthest {
  double corner = 0.0, inside = 0.0;
  int facets = 0;
};
template <class Wanted, class Error>
Farthest farthest(const SurfaceMesh& m, const Wanted& wanted, const Error& error)
{
  Farthest far;
  for (const Triangle& t : m.triangles) {
    if (!first_quarter(m, t) || !wanted(t)) continue;
    ++far.facets;
    for (const int i : t) far.corner = std::max(far.corner, error(m.points[i]));
    for (const Vec3& p : samples(m, t)) far.inside = std::max(far.inside, error(p));
  }
  return far;
}

constexpr double rounding = 1e-10, limit = 0.02 * mm;

void expect_within(const Farthest& far, int least_facets)
{
  EXPECT_GE(far.facets, least_facets);
  EXPECT_LE(far.corner, rounding);
  EXPECT_LE(far.inside, limit);
  EXPECT_GE(far.inside, 0.3 * limit); // the measure sees something, and facets are not wasted
  ::testing::Test::RecordProperty("chord_error_um", std::to_string(far.inside * 1e6));
}

TEST(ToolSurface, DoubleDomePunchIsWithinItsChordError)
{
  const SurfaceMesh m = build("double-dome", "punch");
  const Punch punch{.apex = 0.5 * mm};
  const auto not_cap = [&](const Triangle& t) {
    return std::abs(normalized(area_vector(m, t)).z) < 0.99999 || m.points[t[0]].z < 40 * mm;
  };
  expect_within(farthest(m, not_cap, [&](const Vec3& p) { return punch.distance(p); }), 4000);
}

TEST(ToolSurface, DoubleDomeCavityKeepsTheGapEverywhere)
{
  const SurfaceMesh m = build("double-dome", "die");
  const auto error = [&](const Vec3& p) { return std::abs(closed.distance(p) - 3 * mm); };
  const auto cavity = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int i) { return error(m.points[i]) < rounding; });
  };
  expect_within(farthest(m, cavity, error), 4000);
}

TEST(ToolSurface, DoubleDomeEntryIsRolledByABall)
{
  const SurfaceMesh m = build("double-dome", "die");
  const auto error = [&](const Vec3& p) { return std::abs(norm(p - balls.nearest(p).first) - 12 * mm); };
  const auto fillet = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int i) {
      const Vec3& p = m.points[i];
      return p.z > -14 * mm && p.x < 349 * mm && p.y < 249 * mm && error(p) < rounding;
    });
  };
  expect_within(farthest(m, fillet, error), 2500);
}

TEST(ToolSurface, DoubleDomeDieHasNothingButCavityFilletAndFlats)
{
  const SurfaceMesh m = build("double-dome", "die");
  for (const Vec3& p : m.points) {
    if (p.x < 0.0 || p.y < 0.0 || p.z == -0.5 * mm || p.z < -82 * mm) continue;
    const bool cavity = std::abs(closed.distance(p) - 3 * mm) < rounding;
    EXPECT_TRUE(cavity || std::abs(norm(p - balls.nearest(p).first) - 12 * mm) < rounding)
        << p.x << " " << p.z;
  }
}

TEST(ToolSurface, DoubleDomeHolderBeginsWhereTheDieIsFlat)
{
  const SurfaceMesh m = build("double-dome", "holder");
  const auto outside = [&](const Vec3& p) {
    const auto [c, out] = balls.nearest(p);
    return dot(p - c, out); // from the opening, in plan
  };
  const auto wall = [&](const Vec3& p) { return std::abs(outside({p.x, p.y, balls.z})); };
  const auto on_wall = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](int i) { return wall(m.points[i]) < rounding; });
  };
  const Farthest far = farthest(m, on_wall, wall);
  EXPECT_GE(far.facets, 200);
  EXPECT_LE(far.inside, limit);

  const auto rounded = [&](const Vec3& p) {
    return std::abs(std::hypot(5 * mm - outside({p.x, p.y, balls.z}), p.z - 5.5 * mm) - 5 * mm);
  };
  const auto on_round = [&](const Triangle& t) {
    return std::abs(normalized(area_vector(m, t)).z) < 0.9999 && std::all_of(t.begin(), t.end(), [&](int i) {
             return m.points[i].z < 5.6 * mm && rounded(m.points[i]) < rounding;
           });
  };
  expect_within(farthest(m, on_round, rounded), 2500);
}

TEST(ToolSurface, HemisphereIsWithinItsChordError)
{
  const auto on = [](const SurfaceMesh& m, double error_limit, const auto& error) {
    return [&m, error_limit, &error](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](int i) { return error(m.points[i]) < error_limit; });
    };
  };
  const SurfaceMesh punch = build("hemisphere", "punch");
  const auto sphere = [](const Vec3& p) {
    return p.z > 75.5 * mm ? std::abs(std::hypot(p.x, p.y) - 75 * mm)
                           : std::abs(norm(p - Vec3{0.0, 0.0, 75.5 * mm}) - 75 * mm);
  };
  expect_within(farthest(punch, on(punch, rounding, sphere), sphere), 3000);

  const auto torus = [](const Vec3& p, double radius, double z, double r) {
    return std::abs(std::hypot(std::hypot(p.x, p.y) - radius, p.z - z) - r);
  };
  const SurfaceMesh die = build("hemisphere", "die"), holder = build("hemisphere", "holder");
  const auto entry = [&](const Vec3& p) { return torus(p, 87.5 * mm, -8 * mm, 7.5 * mm); };
  expect_within(farthest(die, on(die, rounding, entry), entry), 1000);
  const auto edge = [&](const Vec3& p) { return torus(p, 92.5 * mm, 5.5 * mm, 5 * mm); };
  expect_within(farthest(holder, on(holder, rounding, edge), edge), 1000);
}

TEST(ToolSurface, ChordErrorIsObeyedWhenItIsChanged)
{
  for (const double e : {0.005 * mm, 0.3 * mm}) {
    const SurfaceMesh m = build("double-dome", "die", {{"chord-error", e}});
    const auto error = [&](const Vec3& p) { return std::abs(closed.distance(p) - 3 * mm); };
    const auto cavity = [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](int i) { return error(m.points[i]) < rounding; });
    };
    const Farthest far = farthest(m, cavity, error);
    EXPECT_LE(far.inside, e);
    EXPECT_GE(far.inside, 0.3 * e);
  }
}

TEST(ToolSurface, TangentPlanesAreContinuous)
{
  const shapes::DomeSurface s{.radius = 65 * mm, .waist = 55 * mm, .centre = 120 * mm, .draft = 5 * degree};
  constexpr double e = 1e-7; // both sides differ by a curvature times this
  for (int i = 0; i <= 40; ++i) {
    const double along = 1.9 * i / 40.0; // over the arc and onto the wall
    EXPECT_LT(norm(s.point(1.0 - e, along) - s.point(1.0, along)), 1e-7);
    EXPECT_LT(norm(s.normal(1.0 - e, along) - s.normal(1.0 + e, along)), 1e-6);
    const double u = 2.0 * i / 40.0;
    EXPECT_LT(norm(s.normal(u, s.arc_end() - e) - s.normal(u, s.arc_end() + e)), 1e-6);
  }
  EXPECT_EQ(s.normal(0.0, 0.7).x, 0.0);
}

TEST(ToolSurface, NormalsAreThoseOfTheSurface)
{
  const shapes::DomeSurface s{.radius = 65 * mm, .waist = 40 * mm, .centre = 70 * mm, .draft = 10 * degree};
  constexpr double e = 1e-6;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 19; ++k) {
      const double u = 0.05 + 0.1 * i, v = 0.05 + 0.1 * k;
      const Vec3 along = normalized(s.point(u + e, v) - s.point(u - e, v));
      const Vec3 up = normalized(s.point(u, v + e) - s.point(u, v - e));
      const Vec3 n = normalized(cross(along, up)); // out of the punch, by the direction of u
      EXPECT_LT(norm(n + s.normal(u, v)), 1e-5) << u << " " << v;
    }
}

TEST(ToolSurface, ConcaveCurvatureIsThatOfTheOffsetWhichFolds)
{
  // A straight tube has none; in a deep waist with a wall the outline's own curvature is the largest.
  const shapes::DomeSurface tube{.radius = 50 * mm, .waist = 50 * mm, .centre = 100 * mm, .draft = 0.0};
  EXPECT_NEAR(tube.concave_curvature(1.5), 0.0, 1e-9);
  const shapes::DomeSurface waist{.radius = 50 * mm, .waist = 30 * mm, .centre = 100 * mm, .draft = 0.0};
  EXPECT_NEAR(waist.concave_curvature(std::numbers::pi / 2.0), waist.outline_curvature(),
              1e-6 * waist.outline_curvature());
}

/// Facets on an arc of curvature k within a chord error e turn by at most sqrt(8 e k); edges that are meant
/// to be sharp turn by more than 60 degrees.
TEST(ToolSurface, SmoothFacesTurnNoMoreThanTheirChordErrorImplies)
{
  const auto smooth = [](const std::string& shape, const std::string& part, double radius) {
    const double turn = std::sqrt(8.0 * 0.02 * mm / radius);
    double largest = 0.0;
    for (const double angle : dihedral_angles(build(shape, part))) {
      EXPECT_TRUE(angle <= turn || angle > 60 * degree) << shape << " " << part << " " << angle / degree;
      if (angle < 60 * degree) largest = std::max(largest, angle);
    }
    EXPECT_GT(largest, 0.4 * turn);
  };
  smooth("double-dome", "punch", 55.0 * 55.0 / 65.0 * mm); // the waist's section is an ellipse
  smooth("double-dome", "die", 12 * mm);
  smooth("double-dome", "holder", 5 * mm);
  smooth("hemisphere", "punch", 75 * mm);
  smooth("hemisphere", "die", 7.5 * mm);
  smooth("hemisphere", "holder", 5 * mm);
}

/// Distance of a point from the male dome's profile, whose crown is at z = 0: by looking everywhere on it.
double distance_from_hill(const Vec3& p)
{
  const double d = std::hypot(std::max(std::abs(p.x) - 305 * mm, 0.0), p.y);
  double best = 1.0;
  constexpr int samples = 20000;
  for (int i = 0; i <= samples; ++i) {
    const double at = 0.15 * i / samples, t = std::clamp((at - 27 * mm) / (102.6 * mm), 0.0, 1.0);
    best = std::min(best, std::hypot(d - at, p.z + 60 * mm * (1.0 - std::cos(std::numbers::pi * t))));
  }
  return best;
}

TEST(MaleDome, LiesOnTheExactHillAndThePressClosesAtItsGap)
{
  const auto look = [](const char* part, double crown_z, double gap) {
    const SurfaceMesh m = build("male-dome", part);
    double worst = 0.0;
    int looked = 0;
    for (std::size_t i = 0; i < m.triangles.size(); i += 29) {
      const auto& [a, b, c] = m.triangles[i];
      Vec3 middle = (1.0 / 3.0) * (m.points[a] + m.points[b] + m.points[c]);
      middle.z -= crown_z;
      if (middle.z > 10 * mm || middle.z < -115 * mm) continue;                     // the back and the flange
      if (std::abs(middle.x) > 500 * mm || std::abs(middle.y) > 250 * mm) continue; // the walls
      worst = std::max(worst, std::abs(distance_from_hill(middle) - gap));
      ++looked;
    }
    EXPECT_GT(looked, 300) << part;
    EXPECT_LT(worst, 0.1 * mm) << part;
  };
  look("mould", -0.5 * mm, 0.0);
  // The press has come down by height + sheet - gap when closed.
  look("press", -0.5 * mm + 118 * mm, 3 * mm);
}

} // namespace
} // namespace towform::tool_tests
