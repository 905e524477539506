#include "output/hdf5.hpp"
#include "press_case.hpp"
#include "solver/model.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>

namespace towform {
namespace {

class Gate : public Press {
protected:
  /// Runs into a gate, and finds everything computed until then readable. Returns the message.
  std::string stop(const std::vector<std::string>& overrides, ExitCode code) const
  {
    const RunOutcome outcome = form(overrides);
    const Summary& s = outcome.summary;
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(s.status, "stopped");
    EXPECT_TRUE(std::regex_search(s.message, std::regex("^stopped at t = [0-9.]+ ms, step [0-9]+: ")))
        << s.message;
    EXPECT_LT(s.simulated_time_s, 5e-3 * (1.0 + 1e-12));

    const auto json = nlohmann::json::parse(text_of(out / "summary.json"));
    EXPECT_EQ(json["status"], "stopped");
    EXPECT_EQ(json["message"], s.message);
    EXPECT_EQ(json["steps"], s.steps);

    const hdf5::File file = hdf5::File::open(out / "results.h5", hdf5::File::Mode::read);
    EXPECT_EQ(hdf5::text_attribute(file.id(), "status"), s.message);
    const auto frames = hdf5::link_names(hdf5::open_group(file.id(), "frames").id());
    EXPECT_GE(frames.size(), 1U);
    for (const std::string& frame : frames)
      for (const double x :
           hdf5::read_numbers(hdf5::open_dataset(file.id(), "frames/" + frame + "/position")))
        EXPECT_TRUE(std::isfinite(x));
    EXPECT_NE(text_of(out / "results.xdmf").find("</Xdmf>"), std::string::npos);

    const std::string history = text_of(out / "history.csv");
    EXPECT_GE(std::count(history.begin(), history.end(), '\n'), 2); // names, and the start
    EXPECT_EQ(history.back(), '\n');
    EXPECT_EQ(history.find("nan"), std::string::npos);
    return s.message;
  }
};

void expect_says(const std::string& message, const std::string& part)
{
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST_F(Gate, NoneStopsAGoodRun)
{
  const RunOutcome outcome = form();
  EXPECT_EQ(outcome.code, ExitCode::done);
  EXPECT_EQ(outcome.summary.status, "done");
  EXPECT_EQ(outcome.summary.message, "");
  EXPECT_DOUBLE_EQ(outcome.summary.simulated_time_s, 5e-3);
  EXPECT_GT(outcome.summary.shear_angle_max_deg, 0.1);
  EXPECT_GT(outcome.summary.punch_force_max_N, 0.1);
}

TEST_F(Gate, Energy)
{
  const std::string message = stop({"gates.energy_error=1e-9"}, ExitCode::stability_gate);
  expect_says(message, "energy account is off by");
  expect_says(message, "gates.energy_error");
}

TEST_F(Gate, KineticOverInternal)
{
  const std::string message = stop({"gates.kinetic_to_internal=1e-6"}, ExitCode::stability_gate);
  expect_says(message, "kinetic energy is");
  expect_says(message, "t = 2.5 ms"); // not before the second half
}

TEST_F(Gate, Penetration)
{
  const std::string message = stop({"gates.penetration=1e-9"}, ExitCode::contact_gate);
  expect_says(message, " mm inside tool '");
  EXPECT_TRUE(std::regex_search(message, std::regex("node [0-9]+ \\(x = -?[0-9.]+, y = -?[0-9.]+ mm")))
      << message;
}

TEST_F(Gate, PenetrationBetweenOutputs)
{
  // One row of history, at the end: what a run was in between counts too.
  const std::string message =
      stop({"gates.penetration=1e-6", "output.history=1", "output.frames=1"}, ExitCode::contact_gate);
  EXPECT_TRUE(std::regex_search(message, std::regex(" mm inside tool '\\w+' at t = [0-4]\\.[0-9]+ ms")))
      << message;
}

TEST_F(Gate, PenetrationOfAToolThatLeapsNamesTheLeap)
{
  const std::string message =
      stop({"tool.ball.motion.displacement=-0.4", "gates.penetration=1e-5"}, ExitCode::contact_gate);
  expect_says(message, "mm in that step: press more slowly");
}

TEST_F(Gate, SelectiveMassScalingLeavesTheFastestWavesAsTheyAre)
{
  // Element 0 made heavy: waves are slower in it, not in the sheet.
  const Case c = read({"time.step=50 us", "blank.pattern=unstructured"});
  const Model model = build_model(c);
  EXPECT_GT(model.added_mass_fraction, 0.1);
  EXPECT_LE(model.wave_speed, 822.1);
  const std::vector<double> area = model.membrane.areas();
  for (std::size_t e = 0; e < model.element_mass.size(); ++e)
    EXPECT_GE((1.0 + 1e-12) * model.wave_speed,
              std::sqrt(model.membrane.yarn.stiffness * area[e] / model.element_mass[e]));
}

TEST_F(Gate, YarnStrain)
{
  const std::string message = stop({"gates.yarn_strain=1e-6"}, ExitCode::stability_gate);
  expect_says(message, "strain their yarns");
  EXPECT_TRUE(std::regex_search(message, std::regex("element [0-9]+ \\(x = "))) << message;
}

TEST_F(Gate, AToolFasterThanWaves)
{
  // 6 km/s: it would pass through the sheet between two steps and leave no trace.
  const std::string message = stop({"tool.ball.motion.displacement=-30"}, ExitCode::stability_gate);
  expect_says(message, "tool 'ball' moves at 6e+03 m/s, faster than waves in the yarns (822 m/s)");
}

TEST_F(Gate, MotionFasterThanWaves)
{
  // Just slower than waves itself, the ball throws nodes ahead of it.
  const std::string message = stop({"tool.ball.motion.displacement=-4", "contact.penalty=0.5",
                                    "gates.penetration=1", "gates.yarn_strain=100"},
                                   ExitCode::stability_gate);
  expect_says(message, "faster than waves in the yarns (822 m/s)");
  EXPECT_TRUE(std::regex_search(message, std::regex("node [0-9]+ \\(x = "))) << message;
}

TEST_F(Gate, CollapsedElement)
{
  // Two grips bring opposite edges together: the yarns between them are left without length. Small steps: the stable one falls
  // fast, and must be looked at again before the sheet runs away.
  text += R"([[boundary]]
name = "west"
edge = "left"
motion = { axis = "x", profile = "table", table = [[0, 0], ["3 ms", "29.99 mm"], ["5 ms", "29.99 mm"]] }
[[boundary]]
name = "east"
edge = "right"
motion = { axis = "x", profile = "table", table = [[0, 0], ["3 ms", "-29.99 mm"], ["5 ms", "-29.99 mm"]] }
)";
  const std::string message =
      stop({"tool.ball.position=[0, 0, 0.01]", "blank.elements=8", "time.safety=0.3", "material.compression_factor=0",
            "material.relaxation_ratio=1", "gates.penetration=1", "gates.yarn_strain=100", "gates.energy_error=1e9",
            "gates.kinetic_to_internal=1e9"},
           ExitCode::stability_gate);
  expect_says(message, "which has collapsed");
  EXPECT_TRUE(std::regex_search(message, std::regex("element [0-9]+"))) << message;
}

} // namespace
} // namespace towform
