#include "contact/one_contact.hpp"
#include "contact/shapes.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

constexpr double dt = 1e-5, mass = 1e-3, half = 0.5e-3, mass_per_area = 1.5, area = mass / mass_per_area;

/// One node of a sheet against one tool, under a body force.
struct Block {
  Tool tool;
  ToolState tool_state;
  Contact contact;
  ContactState contact_state;
  State s;
  Vec3 weight;
  double work = 0.0; ///< of the weight

  Block(SurfaceMesh mesh, double friction, double damping, const Vec3& at)
      : tool{"tool", ToolSurface(std::move(mesh)), friction, {}, {}, {0, 0, 1}, 0.0},
        contact(tool, 0, half, 0.1, damping, mass_per_area, dt)
  {
    s.position = {at};
    s.velocity = {{}};
    s.force = {{}};
    start(contact, 1, contact_state);
  }

  void step()
  {
    const Vec3 before = s.position[0];
    s.force[0] += weight;
    s.velocity[0] += (dt / mass) * s.force[0];
    s.position[0] += dt * s.velocity[0];
    work += dot(weight, s.position[0] - before);
    s.force[0] = {};
    test::contact_forces(contact, tool, tool_state, contact_state, area, s, dt);
  }
  [[nodiscard]] double stiffness() const { return contact.stiffness_per_area * area; }
  [[nodiscard]] double energy() const
  {
    const ContactEnergies& e = contact_state.energies;
    const Vec3& v = s.velocity[0];
    const double kinetic = 0.5 * (mass * norm_squared(v) + dt * dot(v, s.force[0] + weight));
    return kinetic + e.elastic + e.friction + e.damping - work;
  }
};

SurfaceMesh ground() { return test::box({-1, -1, -0.2}, {1, 1, 0}); }

TEST(Contact, ABounceGivesItsEnergyBack)
{
  Block block(ground(), 0.0, 0.0, {0.13, 0.21, 0.01});
  block.s.velocity[0] = {0.0, 0.0, -0.8};
  const double start = 0.5 * mass * 0.64;
  bool touched = false;
  for (int i = 0; i < 3000; ++i) {
    block.step();
    touched = touched || block.contact_state.penetration > 0.0;
  }
  EXPECT_TRUE(touched);
  EXPECT_NEAR(block.s.velocity[0].z, 0.8, 0.02);
  EXPECT_NEAR(block.energy(), start,
              0.04 * start); // the step in which contact closes is not resolved further
}

TEST(Contact, IsSoftAtFirstTouch)
{
  constexpr double soft = 0.1, depth = 1e-5;
  for (const double share : {0.5, 1.0, 3.0, 20.0}) { // of the force at which it is soft no longer
    Block block(ground(), 0.0, 0.3, {0.1, 0.2, half});
    block.contact.soft = soft;
    block.contact.soft_depth = depth;
    const double force = share * soft * depth * block.stiffness();
    block.weight = {0.0, 0.0, -force};
    for (int i = 0; i < 5000; ++i) block.step();
    const double expected = share < 1.0 ? share * depth : depth + (share - 1.0) * soft * depth;
    EXPECT_NEAR(half - block.s.position[0].z, expected, 1e-12) << share;
    const double at_joint = 0.5 * soft * depth * depth, beyond = expected - depth;
    const double stored = share < 1.0 ? 0.5 * soft * expected * expected
                                      : at_joint + soft * depth * beyond + 0.5 * beyond * beyond;
    EXPECT_NEAR(block.contact_state.energies.elastic, block.stiffness() * stored, 1e-9 * block.stiffness() * stored) << share;
  }
}

TEST(Contact, ASoftBounceGivesItsEnergyBack)
{
  Block block(ground(), 0.0, 0.0, {0.13, 0.21, 0.0006});
  block.contact.soft = 0.1;
  block.contact.soft_depth = 1e-5;
  block.s.velocity[0] = {0.0, 0.0, -0.3};
  const double start = 0.5 * mass * 0.09;
  double deepest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    block.step();
    deepest = std::max(deepest, block.contact_state.penetration);
    ASSERT_NEAR(block.energy(), start, 0.02 * start) << i;
  }
  EXPECT_GT(deepest, 1.5e-5);
  EXPECT_NEAR(block.s.velocity[0].z, 0.3, 0.01 * 0.3);
}

TEST(Contact, CountsWhatItsDashpotTakes)
{
  for (const double damping : {0.1, 0.5}) {
    Block block(ground(), 0.0, damping, {0.13, 0.21, 0.0006});
    block.contact.soft = 0.1;
    block.contact.soft_depth = 1e-5;
    block.s.velocity[0] = {0.0, 0.0, -0.3};
    const double start = 0.5 * mass * 0.09;
    for (int i = 0; i < 1000; ++i) {
      block.step();
      ASSERT_NEAR(block.energy(), start, 0.02 * start) << damping << ", step " << i;
    }
    EXPECT_LT(block.s.velocity[0].z, 0.25);
    EXPECT_GT(block.contact_state.energies.damping, 0.3 * start);
  }
}

TEST(Contact, HoldsTheSheetOffByHalfItsThicknessOnEitherFace)
{
  for (const double side : {1.0, -1.0}) {
    Block block(side > 0.0 ? ground() : test::box({-1, -1, 0}, {1, 1, 0.2}), 0.0, 0.3,
                {0.1, 0.2, side * half});
    block.weight = {0.0, 0.0, -side * 0.01};
    for (int i = 0; i < 5000; ++i) block.step();
    EXPECT_NEAR(block.s.position[0].z, side * (half - 0.01 / block.stiffness()), 1e-12);
    EXPECT_NEAR(block.tool_state.reaction.z, -side * 0.01, 1e-6);
  }
}

TEST(Contact, RemembersNothingThatASearchWouldNotFind)
{
  // A node that wanders above, beside and deep inside a box, against one that comes there for the first time.
  const SurfaceMesh box = test::box({-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01});
  Block wanderer(box, 0.0, 0.0, {0.009, 0.0, 0.0102});
  int deep = 0;
  for (int i = 0; i < 4000; ++i) {
    const double a = 0.013 * i, b = 0.0071 * i;
    const Vec3 at{0.0105 + 1.3e-3 * std::cos(a), 2e-3 * std::sin(b), 0.0098 + 1.2e-3 * std::sin(1.3 * a)};
    Block newcomer(box, 0.0, 0.0, at);
    for (Block* block : {&wanderer, &newcomer}) {
      block->s.position[0] = at;
      block->s.force[0] = {};
      test::contact_forces(block->contact, block->tool, block->tool_state, block->contact_state, area, block->s, dt);
    }
    deep += newcomer.contact_state.penetration > half ? 1 : 0;
    ASSERT_EQ(wanderer.s.force[0], newcomer.s.force[0]) << i;
    ASSERT_EQ(wanderer.contact_state.penetration, newcomer.contact_state.penetration) << i;
  }
  EXPECT_GT(deep, 100);
}

TEST(Contact, SticksOnASlopeBelowTheFrictionAngleAndDoesNotCreep)
{
  Block block(ground(), 0.4, 0.3, {0.0, 0.0, half});
  const double pull = 0.01 * 0.35; // weight on a slope of tan = 0.35
  block.weight = {pull, 0.0, -0.01};
  for (int i = 0; i < 20000; ++i) block.step();
  const double settled = block.s.position[0].x;
  EXPECT_NEAR(settled, pull / block.stiffness(), 0.2 * pull / block.stiffness());
  for (int i = 0; i < 20000; ++i) block.step();
  EXPECT_NEAR(block.s.position[0].x, settled, 1e-9);
}

TEST(Contact, SlidesAboveTheFrictionAngleWithTheRightAcceleration)
{
  Block block(ground(), 0.4, 0.3, {0.0, 0.0, half});
  block.weight = {0.01 * 0.6, 0.0, -0.01};
  const int steps = 20000;
  for (int i = 0; i < steps; ++i) block.step();
  const double acceleration = 0.01 * (0.6 - 0.4) / mass;
  EXPECT_NEAR(block.s.velocity[0].x, acceleration * steps * dt, 2e-3 * acceleration * steps * dt);
  EXPECT_NEAR(block.contact_state.energies.friction, 0.4 * 0.01 * block.s.position[0].x,
              5e-3 * block.contact_state.energies.friction);
  EXPECT_NEAR(block.energy(), 0.0, 5e-3 * block.work);
}

TEST(Contact, ABlockStopsWhereFrictionHasEatenItsEnergy)
{
  Block block(ground(), 0.3, 0.3, {0.0, 0.0, half});
  block.weight = {0.0, 0.0, -0.01};
  for (int i = 0; i < 2000; ++i) block.step(); // settle
  block.s.velocity[0].x = 0.5;
  for (int i = 0; i < 40000; ++i) block.step();
  EXPECT_NEAR(block.s.position[0].x, 0.5 * mass * 0.25 / (0.3 * 0.01), 0.005 * 0.0417);
  const double rest = block.s.position[0].x;
  for (int i = 0; i < 20000; ++i) block.step();
  EXPECT_NEAR(block.s.position[0].x, rest, 1e-8);
}

TEST(Contact, AMovingToolDragsTheSheetUntilItSlips)
{
  Block block(ground(), 0.3, 0.3, {0.0, 0.0, half});
  block.tool.direction = {1, 0, 0};
  block.weight = {0.0, 0.0, -0.01};
  block.tool_state.velocity = 0.2;
  for (int i = 0; i < 20000; ++i) {
    block.tool_state.displacement += 0.2 * dt;
    block.step();
  }
  EXPECT_NEAR(block.s.velocity[0].x, 0.2, 1e-4);
}

TEST(Contact, TheSearchMemoryNeverChangesTheForces)
{
  // A node wandering round a sphere: remembered facets against a fresh search at every step.
  Tool tool{"ball", ToolSurface(test::sphere(0.05, 16)), 0.0, {}, {}, {0, 0, 1}, 0.0};
  ToolState moving, fresh_tool;
  const Contact contact(tool, 0, half, 0.1, 0.0, mass_per_area, dt);
  State s;
  s.velocity = {{}};
  ContactState remembered;
  start(contact, 1, remembered);
  int touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const double turn = 2e-3 * i;
    const double r = 0.0503 + 6e-4 * std::sin(0.37 * turn);
    const Vec3 x = r * Vec3{std::cos(turn) * std::cos(0.1 * turn), std::sin(turn) * std::cos(0.1 * turn),
                            std::sin(0.1 * turn)};
    s.position = {x};
    s.force = {{}};
    test::contact_forces(contact, tool, moving, remembered, area, s, dt);
    const Vec3 force = s.force[0];
    ContactState fresh;
    start(contact, 1, fresh);
    s.force = {{}};
    test::contact_forces(contact, tool, fresh_tool, fresh, area, s, dt);
    ASSERT_EQ(force, s.force[0]) << "step " << i;
    if (norm(force) > 0.0) ++touching;
  }
  EXPECT_GT(touching, 5000);
  EXPECT_LT(touching, 15000);
}

TEST(Contact, NodesThatWereAwayAreFoundAgainWhenTheyOrTheToolHaveComeNear)
{
  // Six nodes that fall on a ball from different heights, slide on it and rise again, the ball beating time: once with what they
  // moved known, once looking at all of them at every step.
  Tool tool{"ball", ToolSurface(test::sphere(0.05, 16)), 0.0, {}, {}, {0, 0, 1}, 0.0};
  const Contact contact(tool, 0, half, 0.1, 0.0, mass_per_area, dt);
  constexpr int nodes = 6, steps = 20000;
  const auto height = [](int n, int i) { return 0.051 + 0.004 * n + (0.006 + 0.004 * n) * std::cos(2e-4 * (1 + n) * i); };
  ToolState tool_state;
  ContactState known, unknown;
  start(contact, nodes, known);
  start(contact, nodes, unknown);
  State s;
  s.velocity.assign(nodes, {});
  s.position.assign(nodes, {});
  int touching = 0, away = 0;
  for (int i = 0; i < steps; ++i) {
    double moved = 0.0;
    for (int n = 0; n < nodes; ++n) {
      const Vec3 to{1e-3 * n + 8e-3 * std::sin(1e-3 * (1 + n) * i), 0.0, height(n, i)};
      moved = std::max(moved, norm(to - s.position[n]));
      s.position[n] = to;
    }
    tool_state.displacement = 8e-3 * std::sin(0.01 * i);
    s.force.assign(nodes, {});
    test::contact_forces(contact, tool, tool_state, known, area, s, dt, moved);
    const std::vector<Vec3> force = s.force;
    s.force.assign(nodes, {});
    test::contact_forces(contact, tool, tool_state, unknown, area, s, dt);
    ASSERT_EQ(force, s.force) << "step " << i;
    touching += std::any_of(force.begin(), force.end(), [](const Vec3& f) { return norm(f) > 0.0; });
    away += known.planes.way < known.planes.quiet_until[0];
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(away, 500); // nobody was looked at
}

TEST(Tool, AForcedToolAcceleratesAndItsWorkIsAccounted)
{
  Tool tool{"holder", ToolSurface(ground()), 0.0, {}, -35.0, {0, 0, 1}, 0.5};
  ToolState s;
  for (int i = 0; i < 1000; ++i) {
    const double before = s.displacement;
    advance(tool, s, i * dt, dt, dt);
    account_work(tool, s, {}, s.displacement - before);
  }
  EXPECT_NEAR(s.velocity, -35.0 / 0.5 * 0.01, 1e-9);
  EXPECT_NEAR(s.work, -35.0 * s.displacement, 1e-12);
}

TEST(Contact, TellsOfNodesThatTouchMoreToolsThanAreCountedOfThem)
{
  for (const double lid_at : {0.8e-3, 1.2e-3}) {
    const auto plate = [](double low, double high) { return ToolSurface(test::box({-0.01, -0.01, low}, {0.01, 0.01, high})); };
    const Tool tools[] = {{"floor", plate(-0.01, 0.0), 0.0, {}, {}, {0, 0, 1}, 0.0},
                          {"lid", plate(lid_at, lid_at + 0.01), 0.0, {}, {}, {0, 0, 1}, 0.0}};
    std::vector<Contact> contacts;
    std::vector<ContactState> states(2);
    for (int i = 0; i < 2; ++i) {
      contacts.emplace_back(tools[i], i, half, 0.1, 0.0, mass_per_area, dt);
      start(contacts.back(), 2, states[static_cast<std::size_t>(i)]);
    }
    State s;
    s.position = {{0.0, 0.0, 0.4e-3}, {0.001, 0.0, 0.6e-3}}; // the other on neither, or on the lid
    s.velocity.assign(2, {});
    s.force.assign(2, {});
    ToolState tool_states[2];
    const std::vector<double> areas(2, area);
    const auto asks = [&](const std::vector<double>& counted) {
      return contact_forces(contacts, tools, tool_states, states, areas, counted, s, dt, HUGE_VAL);
    };
    const bool pinched = lid_at < 1e-3;
    EXPECT_EQ(asks({1.0, 1.0}), pinched);
    EXPECT_EQ(asks({1.0, 2.0}), pinched);
    EXPECT_FALSE(asks({2.0, 1.0}));
    EXPECT_FALSE(asks({}));
  }
}

} // namespace
} // namespace towform
