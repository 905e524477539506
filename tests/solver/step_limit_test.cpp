#include "case/float_traps.hpp"
#include "element/step_limit.hpp"
#include "solver/bare_sheet.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace towform {
namespace {

/// The largest frequency of the whole sheet, linearised at a shape: power iteration on differences of its real forces.
double true_limit(const Model& model, const std::vector<Vec3>& shape)
{
  const auto forces = [&](const std::vector<Vec3>& x) {
    System s = at_rest(model);
    s.sheet.position = x;
    start(model.membrane, s.sheet);
    for (std::size_t i = 0; i < model.bending.size(); ++i) start(model.bending[i], x, s.bending[i]);
    Phases untimed;
    evaluate_forces(model, s, 1e-12, untimed);
    return s.sheet.force;
  };
  const std::vector<Vec3> rest = forces(shape);
  System moving = at_rest(model);
  test::shake(moving, 1.0);
  std::vector<Vec3> mode = moving.sheet.velocity;
  double omega_squared = 0.0;
  for (int k = 0; k < 1500; ++k) {
    double size = 0.0, next = 0.0;
    for (const Vec3& m : mode) size += norm_squared(m);
    std::vector<Vec3> x = shape;
    const double step = 1e-8 / std::sqrt(size);
    for (std::size_t n = 0; n < x.size(); ++n) x[n] += step * mode[n];
    const std::vector<Vec3> there = forces(x);
    for (std::size_t n = 0; n < x.size(); ++n) {
      mode[n] = (1.0 / (model.mass[n] * step)) * (rest[n] - there[n]);
      next += norm_squared(mode[n]);
    }
    omega_squared = std::sqrt(next / size);
    for (Vec3& m : mode) m *= 1.0 / std::sqrt(next);
  }
  return 2.0 / std::sqrt(omega_squared);
}

double measured(const Model& model, const std::vector<Vec3>& shape)
{
  return StepLimit(model.blank, model.membrane, model.mass, model.shear_modulus, model.bending).at(shape);
}

Case sheet(Pattern pattern, double degrees)
{
  Case c = test::bare_sheet();
  c.blank.pattern = pattern;
  c.blank.fibre_angle = degrees * M_PI / 180.0;
  c.time.lumping = 0.2;
  return c;
}

constexpr Pattern all_patterns[] = {Pattern::diagonal, Pattern::cross, Pattern::unstructured};

TEST(StepLimit, IsTheTrueLimitOfFlatAndShearedSheets)
{
  for (const Pattern pattern : all_patterns)
    for (const double degrees : {0.0, 30.0})
      for (const double shear : {0.0, 0.7}) {
        const Model model = build_model(sheet(pattern, degrees));
        std::vector<Vec3> shape = model.blank.mesh.points;
        for (Vec3& p : shape) { // yarns keep their lengths
          const double along = dot(p, model.blank.warp), across = dot(p, model.blank.weft);
          p = {along + std::sin(shear) * across, std::cos(shear) * across * 0.8, std::cos(shear) * across * 0.6};
        }
        const double truth = true_limit(model, shape), found = measured(model, shape);
        const double bound = StepBound(model.membrane, {model.element_mass, model.mass}, model.shear_modulus)
                                 .at(start(model).sheet)
                                 .step;
        EXPECT_LT(found, 1.005 * truth) << static_cast<int>(pattern) << ", " << degrees << ", " << shear;
        EXPECT_GT(found, 0.98 * truth) << static_cast<int>(pattern) << ", " << degrees << ", " << shear;
        EXPECT_TRUE(shear > 0.0 || found > bound) << found << ", " << bound;
      }
}

TEST(StepLimit, CountsBending)
{
  for (const Pattern pattern : all_patterns)
    for (const double modulus : {1e6, 1e8}) {
      Case c = sheet(pattern, 30.0);
      c.material.fibre_modulus = modulus;
      c.material.bending_stiffness = Vec2{1.0, 0.5};
      const Model model = build_model(c);
      const double truth = true_limit(model, model.blank.mesh.points);
      EXPECT_NEAR(measured(model, model.blank.mesh.points), truth, 0.02 * truth) << static_cast<int>(pattern);
    }
}

TEST(StepLimit, ToolsTakeTheirShareInTheSheetNotSquareToIt)
{
  for (const double slope : {0.0, 1.0}) {
    Case c = sheet(Pattern::diagonal, 0.0);
    c.time.lumping = 0.0; // as much mass everywhere
    const Model model = build_model(c);
    std::vector<Vec3> shape = model.blank.mesh.points;
    for (Vec3& p : shape) p = {p.x, std::cos(slope) * p.y, std::sin(slope) * p.y};
    const double alone = measured(model, shape);
    const double per_area = model.mass[0] / model.membrane.node_area[0] / (alone * alone);
    const auto limit = [&](double normal, double along) {
      const ToolSprings springs{.normal = per_area * normal, .along = per_area * along};
      return StepLimit(model.blank, model.membrane, model.mass, model.shear_modulus, {}, springs).at(shape);
    };
    EXPECT_NEAR(limit(3.0, 0.0), alone, 0.005 * alone) << slope;
    EXPECT_NEAR(limit(3.0, 0.4), alone / std::sqrt(1.1), 0.01 * alone) << slope;
    EXPECT_NEAR(limit(0.4, 0.4), alone / std::sqrt(1.1), 0.01 * alone) << slope;
  }
}

/// The whole has all the modes of its quarter, and those that are not their own mirror images.
TEST(StepLimit, AQuarterHasTheLimitOfTheWholeOrALittleMore)
{
  Case c = sheet(Pattern::cross, 0.0);
  c.blank.elements = 640;
  const Model whole = build_model(c);
  c.blank.symmetry = Symmetry::quarter;
  const Model quarter = build_model(c);
  EXPECT_GT(quarter.first_look.step, 0.999 * whole.first_look.step);
  EXPECT_LT(quarter.first_look.step, 1.01 * whole.first_look.step);
}

TEST(StepLimit, HoldsJustBelowAndBreaksJustAbove)
{
  for (const Pattern pattern : all_patterns)
    for (const double damping : {0.0, 0.3}) {
      Case c = sheet(pattern, 30.0);
      c.material.yarn_damping = damping;
      const Model model = build_model(c);
      const auto growth = [&](double factor) { return test::growth(model, factor * model.first_look.step, 0.01, 200); };
      // With damping near the limit the account breathes.
      EXPECT_LT(growth(0.98), damping > 0.0 ? 2.0 : 1.1) << static_cast<int>(pattern) << ", damping " << damping;
      if (TOWFORM_FLOAT_TRAPS) continue; // breaking ends the program
      EXPECT_EQ(growth(1.04), HUGE_VAL) << static_cast<int>(pattern) << ", damping " << damping;
    }
}

} // namespace
} // namespace towform
