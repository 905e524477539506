#include "contact/shapes.hpp"
#include "output/hdf5.hpp"
#include "output/temporary_directory.hpp"
#include "towform/case.hpp"
#include "towform/run.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace towform {
namespace {

/// Small sheets between boxes whose answers are known.
class ToolContact : public TemporaryDirectory {
protected:
  void box(const std::string& name, const Vec3& low, const Vec3& high) const
  {
    write_stl(directory / (name + ".stl"), test::box(1e-3 * low, 1e-3 * high), name);
  }
  /// Runs a case to its end; `sheet` are the keys of [blank] but its thickness, 1 mm.
  Summary form(const std::string& sheet, const std::string& rest) const
  {
    std::ofstream(directory / "case.toml")
        << "[blank]\nthickness = \"1 mm\"\n"
        << sheet << "\n[material]\ncard = \"gf_pp_twill\"\ntemperature = \"190 degC\"\n"
        << rest;
    const RunOutcome outcome = run(read_case(directory / "case.toml"), {directory / "out", 1, true});
    EXPECT_EQ(outcome.code, ExitCode::done) << outcome.summary.message;
    EXPECT_LT(outcome.summary.energy_error, 0.02);
    return outcome.summary;
  }
  /// A column of history.csv.
  [[nodiscard]] std::vector<double> history(const std::string& column) const
  {
    std::ifstream file(directory / "out/history.csv");
    std::string line, cell;
    std::getline(file, line);
    std::stringstream names(line);
    int wanted = 0;
    while (std::getline(names, cell, ',') && cell != column) ++wanted;
    std::vector<double> values;
    while (std::getline(file, line)) {
      std::stringstream row(line);
      for (int i = 0; i <= wanted; ++i) std::getline(row, cell, ',');
      values.push_back(std::stod(cell));
    }
    return values;
  }
  /// Mean over the last part of the run.
  [[nodiscard]] double late(const std::string& column, double part) const
  {
    const std::vector<double> values = history(column);
    const auto count = static_cast<std::size_t>(part * static_cast<double>(values.size()));
    double sum = 0.0;
    for (std::size_t i = values.size() - count; i < values.size(); ++i) sum += values[i];
    return sum / static_cast<double>(count);
  }
  [[nodiscard]] std::vector<double> values(const std::string& dataset) const
  {
    const hdf5::File file = hdf5::File::open(directory / "out/results.h5", hdf5::File::Mode::read);
    return hdf5::read_numbers(hdf5::open_dataset(file.id(), dataset));
  }
};

TEST_F(ToolContact, AHolderIsLiftedByAFoldAndRestsOnItWithItsForce)
{
  // A ridge comes up through a slot and lifts sheet and holder by its 3 mm.
  box("left", {-40, -40, -20}, {-6, 40, -0.5});
  box("right", {6, -40, -20}, {40, 40, -0.5});
  box("ridge", {-2, -40, -20}, {2, 40, -0.5});
  box("holder", {-20, -40, 0.5}, {20, 40, 20});
  const Summary s = form("size = [\"60 mm\", \"30 mm\"]\nedge = \"5 mm\"", R"(
[[tool]]
name = "left"
mesh = "left.stl"
[[tool]]
name = "right"
mesh = "right.stl"
[[tool]]
name = "ridge"
mesh = "ridge.stl"
motion = { profile = "table", table = [[0, 0], ["15 ms", "0.2 m/s"], ["30 ms", 0]] }
[[tool]]
name = "holder"
mesh = "holder.stl"
force = "-30 N"
mass = "50 g"
[contact]
soft = 1
damping = 0.2
[time]
end = "50 ms"
[output]
history = 500
)");
  EXPECT_NEAR(history("position_holder_m").back(), 3e-3, 0.05e-3);
  EXPECT_NEAR(late("force_holder_N", 0.3), 30.0, 0.6);
  EXPECT_NEAR(late("force_ridge_N", 0.3), -late("force_holder_N", 0.3), 0.1) << "it carries the holder alone";
  EXPECT_LT(s.penetration_max_mm, 0.1);
}

TEST_F(ToolContact, ToolsThatTouchTheSheetAtTheStartDoNotKickIt)
{
  box("below", {-40, -40, -20}, {40, 40, -0.5});
  box("above", {-40, -40, 0.5}, {40, 40, 20});
  form("size = [\"30 mm\", \"30 mm\"]\nedge = \"3 mm\"",
       "[[tool]]\nname = \"below\"\nmesh = \"below.stl\"\n[[tool]]\nname = \"above\"\nmesh = \"above.stl\"\n"
       "[time]\nend = \"2 ms\"\n");
  // STL files hold single precision: the faces may be some 1e-11 m inside.
  for (const double energy : history("energy_kinetic_J")) EXPECT_LT(energy, 1e-12);
}

TEST_F(ToolContact, APinchedSheetIsPulledOutAgainstFrictionOnBothFaces)
{
  box("below", {-20, -20, -20}, {20, 20, -0.5});
  box("above", {-20, -20, 0.5}, {20, 20, 20});
  form("size = [\"80 mm\", \"20 mm\"]\nedge = \"5 mm\"", R"(
[[tool]]
name = "below"
mesh = "below.stl"
friction = 0.25
[[tool]]
name = "above"
mesh = "above.stl"
friction = 0.25
force = "-20 N"
[[boundary]]
name = "grip"
edge = "right"
motion = { axis = "x", profile = "smooth", displacement = "3 mm" }
[time]
end = "40 ms"
[output]
history = 400
)");
  // Slipping in the middle half of the time, when the grip is fast. The holder trembles on its springs, so
  // forces of single moments tell little, but the work of friction tells their mean.
  const std::vector<double> above = history("force_above_N"), below = history("force_below_N"),
                            moved = history("position_grip_m"), friction = history("energy_friction_J");
  EXPECT_NEAR((friction[300] - friction[100]) / (moved[300] - moved[100]), 2.0 * 0.25 * 20.0, 0.1);
  double mean_above = 0.0, mean_below = 0.0;
  for (std::size_t i = 100; i < 300; ++i) {
    mean_above += above[i] / 200.0;
    mean_below += below[i] / 200.0;
  }
  EXPECT_NEAR(mean_above, 20.0, 0.6);
  EXPECT_NEAR(mean_below, -mean_above, 0.02) << "the sheet itself has hardly any inertia";
}

TEST_F(ToolContact, EdgesAndCornersOfAToolDoNotComeThroughTheSheet)
{
  // Held at its edges, the sheet is pushed up by a box with sharp edges and corners that lie between nodes.
  box("box", {-10.7, -9.3, -20}, {10.7, 9.3, -0.5});
  const Summary s = form("size = [\"60 mm\", \"60 mm\"]\nedge = \"3 mm\"", R"(
[[tool]]
name = "box"
mesh = "box.stl"
motion = { profile = "smooth", displacement = "4 mm" }
[[boundary]]
name = "a"
edge = "left"
[[boundary]]
name = "b"
edge = "right"
[[boundary]]
name = "c"
edge = "bottom"
[[boundary]]
name = "d"
edge = "top"
[contact]
penalty = 0.4
[time]
end = "12 ms"
[output]
frames = 1
)");
  EXPECT_LT(s.penetration_max_mm, 0.1);
  const std::vector<double> position = values("frames/0001/position");
  int above = 0;
  for (std::size_t i = 0; i < position.size(); i += 3) {
    if (std::abs(position[i]) > 10.6e-3 || std::abs(position[i + 1]) > 9.2e-3) continue;
    ++above;
    EXPECT_GT(position[i + 2], 4e-3 - 0.1e-3) << "node at " << position[i] << ", " << position[i + 1];
  }
  EXPECT_GT(above, 40);
}

/// A strip of yarns held at both ends under a pressure p is an arc: p R = T, with R sin(a) = L/2 and the
/// yarns' strain a/sin(a) - 1.
TEST_F(ToolContact, APressurisedStripIsAnArcWhoseTensionIsPressureTimesRadius)
{
  const double length = 0.06, stiffness = 1e9 * 1e-3, angle = 0.3;
  const double radius = 0.5 * length / std::sin(angle), strain = angle / std::sin(angle) - 1.0;
  const double pressure = stiffness * strain / radius;
  form("size = [\"60 mm\", \"9 mm\"]\nedge = \"3 mm\"",
       fmt::format("[[boundary]]\nname = \"a\"\nedge = \"left\"\n[[boundary]]\nname = \"b\"\nedge = "
                   "\"right\"\n[load]\npressure = [[0, 0], [\"15 ms\", {}]]\n[time]\nend = \"25 "
                   "ms\"\nmass_damping = 300\n[output]\nframes = 1\n",
                   pressure));
  const std::vector<double> position = values("frames/0001/position");
  double depth = 0.0;
  int middle = 0;
  for (std::size_t i = 0; i < position.size(); i += 3)
    if (std::abs(position[i]) < 1e-3) {
      depth -= position[i + 2];
      ++middle;
    }
  EXPECT_NEAR(depth / middle, radius * (1.0 - std::cos(angle)), 0.005 * radius * (1.0 - std::cos(angle)))
      << "pushed to -z, away from the face that looks along +z";
  const std::vector<double> strains = values("frames/0001/fibre_strain");
  double mean = 0.0;
  for (std::size_t e = 0; e < strains.size(); e += 2)
    mean += strains[e] * 2.0 / static_cast<double>(strains.size());
  EXPECT_NEAR(mean, strain, 0.01 * strain);
  // Slowly loaded, it does the work of p dV, which the yarns hold but for what damping took.
  EXPECT_GT(history("energy_yarn_J").back(), 0.9 * history("energy_external_J").back());
}

} // namespace
} // namespace towform
