#include "output/temporary_directory.hpp"
#include "specimen.hpp"
#include "towform/run.hpp"
#include <gtest/gtest.h>

namespace towform {

using namespace test;

namespace {

constexpr double arm = 0.115;

Boundary only_boundary(const Case& c)
{
  return make_boundary(c.boundaries.back(), c.blank, make_blank(c.blank), c.time.end);
}

} // namespace

TEST(Boundary, FrameKeepsItsArmsAndDividesThemEvenly)
{
  const Case c = framed(specimen({arm, arm}, arm / 4, 1.0), moving(Axis::z, 0.06, 1.0));
  const Boundary frame = only_boundary(c);
  const Blank blank = make_blank(c.blank);
  ASSERT_EQ(frame.nodes.size(), 16U);
  for (const double d : {-0.03, 0.0, 0.01, 0.06}) {
    const double theta = frame_angle(d, arm), half = 0.25 * M_PI - 0.5 * theta;
    for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
      const Vec3 flat = blank.mesh.points[frame.nodes[i]];
      const double u = flat.x + 0.5 * arm, v = flat.y + 0.5 * arm; // along the arms
      const double x = u * std::cos(0.25 * M_PI - half) + v * std::cos(0.25 * M_PI + half);
      const double y = u * std::sin(0.25 * M_PI - half) + v * std::sin(0.25 * M_PI + half);
      const Vec3 place = frame.place(i, d).position;
      EXPECT_NEAR(place.x, x - 0.5 * arm, 1e-15);
      EXPECT_NEAR(place.y, y - 0.5 * arm, 1e-15);
      EXPECT_EQ(place.z, 0.0);
      // The power of the force needs dx/dd.
      constexpr double h = 1e-6;
      const Vec3 slope = (0.5 / h) * (frame.place(i, d + h).position - frame.place(i, d - h).position);
      EXPECT_NEAR(norm(frame.place(i, d).slope - slope), 0.0, 1e-8); // h^2 and rounding over h
    }
  }
}

TEST(Boundary, FrameMayNotCollapse)
{
  const auto make = [](double d) {
    return build_model(framed(specimen({arm, arm}, arm / 2, 1.0), moving(Axis::z, d, 1.0)));
  };
  EXPECT_NO_THROW(make(0.0671)); // 84.9 degrees
  EXPECT_THROW(make(0.0673), InputError);
  EXPECT_THROW(make(0.2), InputError);
  EXPECT_THROW(make(-0.16), InputError);
}

TEST(Boundary, GripsAreWhereTheirMotionSaysToTheBit)
{
  Case c = specimen({0.05, 0.1}, 0.01, 0.2);
  c.blank.fibre_angle = 0.25 * M_PI;
  const Model model = build_model(gripped(c, Edge::bottom, Edge::top, moving(Axis::y, 0.004, 0.2)));
  System s = start(model);
  advance_to(0.1, model, s);
  EXPECT_NEAR(s.boundaries[1].displacement, 0.002, 1e-12);
  ASSERT_FALSE(model.boundaries[0].nodes.empty());
  for (const int n : model.boundaries[0].nodes) EXPECT_EQ(s.sheet.position[n], model.blank.mesh.points[n]);
  const Vec3 moved{0.0, s.boundaries[1].displacement, 0.0};
  ASSERT_FALSE(model.boundaries[1].nodes.empty());
  for (const int n : model.boundaries[1].nodes) {
    EXPECT_EQ(s.sheet.position[n], model.blank.mesh.points[n] + moved);
    EXPECT_NEAR(s.sheet.velocity[n].y, 0.02, 1e-9); // half steps of a constant speed
  }
}

/// Yarns along the pull, stretched evenly: the reaction is exactly tension times width, on the whole strip
/// and on any part of it that mirrors complete.
TEST(Boundary, ReactionOfAStretchedStripIsItsTension)
{
  constexpr double strain = 0.01, length = 0.1, width = 0.04;
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::x, Symmetry::y, Symmetry::quarter}) {
    Case c = specimen({length, width}, 0.01, 1.0);
    c.blank.symmetry = symmetry;
    c.boundaries.push_back(
        {"head", BoundaryParameters::Kind::grip, Edge::right, moving(Axis::x, strain * length, 1.0)});
    const Model model = build_model(c);
    System s = start(model);
    for (Vec3& x : s.sheet.position) x.x *= 1.0 + strain;
    Phases untimed;
    evaluate_forces(model, s, 1e9, untimed); // so slowly that nothing is damped
    const YarnLaw yarn{1e6, 0.1};
    const double force = model.boundaries[0].whole_edge * s.boundaries[0].force;
    EXPECT_NEAR(force / (yarn.tension(strain) * width), 1.0, 1e-10);
    EXPECT_NEAR(force / (1e6 * strain * width), 1.0, 0.01); // E h b strain, but for the smooth switch at 0
  }
}

/// A pull that starts and ends at rest leaves the strip with its elastic energy and force; every joule of the
/// grip's is accounted for.
TEST(Boundary, WorkOfAGripIsAccountedFor)
{
  constexpr double length = 0.1, width = 0.04, pull = 1e-3, end = 0.05;
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::y}) {
    Case c = specimen({length, width}, 0.01, end);
    c.time.mass_scaling = 1.0;
    c.blank.symmetry = symmetry;
    const Model model =
        build_model(gripped(c, Edge::left, Edge::right, moving(Axis::x, pull, end, Motion::Profile::smooth)));
    System s = start(model);
    advance_to(end, model, s);
    const Energies e = energy_account(model, s);
    const YarnLaw yarn{1e6, 0.1};
    EXPECT_NEAR(e.yarn / (length * width * yarn.energy(pull / length)), 1.0, 1e-4);
    EXPECT_NEAR(model.boundaries[1].whole_edge * s.boundaries[1].force /
                    (width * yarn.tension(pull / length)),
                1.0, 1e-3); // still ringing a little
    EXPECT_NEAR(e.external / e.yarn, 1.0, 1e-3);
    EXPECT_LT(e.error(), 1e-5); // trapezoids of 1/1000 of the pull
  }
}

/// Eqs. 13 and 14, and the axial force of the energy model itself, up to 76 degrees.
TEST(PictureFrame, FollowsTheorysAngleRateAndForce)
{
  const double end = 4.65, travel = 2.0 * arm * (std::cos(7.0 * M_PI / 180.0) - 1.0 / std::sqrt(2.0));
  Motion motion = moving(Axis::z, 0.0, end);
  const double speed = travel / (end - 0.1);
  motion.profile = Motion::Profile::table;
  motion.quantity = Motion::Quantity::velocity;
  motion.table = {{0.0, 0.0}, {0.2, speed}, {end, speed}};
  Case c = framed(specimen({arm, arm}, arm / 4, end), motion);
  const Model model = build_model(c);
  const ShearResistance surface(c.material.constituents, c.blank.thickness, c.material.temperature);
  System s = start(model);
  for (const double until : {0.25, 0.5, 0.75, 0.9, 1.0}) {
    advance_to(until * end, model, s);
    const double d = s.boundaries[0].displacement, theta = frame_angle(d, arm);
    const double half = 0.25 * M_PI - 0.5 * theta, rate = speed / (arm * std::sin(half));
    for (const double angle : s.sheet.shear_angle) EXPECT_NEAR(angle, theta, 0.01 * M_PI / 180.0); // inertia, scaled
    // The law's spring takes 0.2 % where N_s rises most.
    for (const double its_rate : s.sheet.shear_rate) EXPECT_NEAR(its_rate / rate, 1.0, 0.005);
    EXPECT_NEAR(s.boundaries[0].force / (2.0 * surface.force(theta, rate) * arm * std::cos(half)), 1.0, 0.01);
  }
  EXPECT_NEAR(frame_angle(s.boundaries[0].displacement, arm), 76.0 * M_PI / 180.0, 1e-9);
  EXPECT_LT(energy_account(model, s).error(), 1e-4);
}

/// Three regions: full shear in the middle, half beside it, none at the grips. The force is that of their
/// power.
TEST(BiasExtension, FollowsTheorysAngleAndForce)
{
  constexpr double width = 0.1, end = 2.5, speed = 0.033 / 3.8, inner = width; // L = 2 W
  Case c = specimen({width, 2.0 * width}, width / (8.0 * std::sqrt(2.0)), end);
  c.blank.fibre_angle = 0.25 * M_PI;
  c.material.relaxation_ratio = 0.1;
  const Model model = build_model(gripped(c, Edge::bottom, Edge::top, moving(Axis::y, speed * end, end)));
  const ShearResistance surface(c.material.constituents, c.blank.thickness, c.material.temperature);
  System s = start(model);
  for (const double until : {0.5, 1.0}) {
    advance_to(until * end, model, s);
    const double cosine = (inner + s.boundaries[1].displacement) / (std::sqrt(2.0) * inner);
    const double theta = 0.5 * M_PI - 2.0 * std::acos(cosine);
    const double rate = std::sqrt(2.0) * speed / (inner * std::sin(0.25 * M_PI - 0.5 * theta));
    for (std::size_t e = 0; e < s.sheet.shear_angle.size(); ++e) {
      const Triangle& t = model.membrane.triangles[e];
      const std::vector<Vec3>& flat = model.blank.mesh.points;
      const Vec3 middle = (1.0 / 3.0) * (flat[t[0]] + flat[t[1]] + flat[t[2]]);
      if (norm(middle) < 0.02) {
        EXPECT_NEAR(s.sheet.shear_angle[e], theta, 0.5 * M_PI / 180.0);
      }
      if (std::abs(middle.y) > 0.08 && std::abs(middle.x) < 0.02) {
        EXPECT_NEAR(s.sheet.shear_angle[e], 0.0, 0.5 * M_PI / 180.0);
      }
    }
    const double power =
        0.5 * width * width * surface.force(theta, rate) * rate * std::cos(theta) +
        width * width * surface.force(0.5 * theta, 0.5 * rate) * 0.5 * rate * std::cos(0.5 * theta);
    EXPECT_NEAR(s.boundaries[1].force / (power / speed), 1.0, 0.02);
  }
  EXPECT_LT(energy_account(model, s).error(), 1e-4);
}

using BoundaryRun = TemporaryDirectory;

TEST_F(BoundaryRun, WithoutToolsLeavesItsForcesAndPassesTheGates)
{
  const std::filesystem::path path = directory / "case.toml";
  std::ofstream(path) << R"([blank]
size = ["40 mm", "40 mm"]
elements = 32
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[boundary]]
name = "foot"
edge = "left"
[[boundary]]
name = "head"
edge = "right"
motion = { axis = "x", displacement = "0.1 mm", profile = "smooth" }
[time]
end = "10 ms"
[output]
history = 4
frames = 2
)";
  const Case c = read_case(path);
  const RunOutcome outcome = run(c, {directory / "out", 1, true});
  EXPECT_EQ(outcome.code, ExitCode::done) << outcome.summary.message;
  EXPECT_EQ(outcome.summary.punch_force_max_N, 0.0); // of tools only
  const std::string history = text_of(directory / "out" / "history.csv");
  EXPECT_EQ(history.find("time_s,step,dt_s,force_head_N,position_head_m,energy_"), 0U) << history;
  EXPECT_EQ(history.find("foot"), std::string::npos); // it is not driven
  EXPECT_NE(history.find(",0.0001,"), std::string::npos) << history;
  EXPECT_NE(describe_run(c).find("boundary 'foot': holds 5 nodes, clamped"), std::string::npos)
      << describe_run(c);
}

} // namespace towform
