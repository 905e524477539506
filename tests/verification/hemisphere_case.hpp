#pragma once
#include "mesh/tool_shapes_helpers.hpp"
#include "output/hdf5.hpp"
#include "output/temporary_directory.hpp"
#include "towform/run.hpp"
#include <fstream>

namespace towform {

/// The hemisphere's first 20 mm on a coarse sheet with coarse tools: all that a press has, in a second.
class CoarseHemisphere : public TemporaryDirectory {
protected:
  CoarseHemisphere()
  {
    for (const char* part : {"punch", "die", "holder"})
      write_stl(directory / fmt::format("{}.stl", part),
                tool_tests::build("hemisphere", part, {{"chord-error", 0.5e-3}}), part);
    std::ofstream(directory / "case.toml") << R"(
[blank]
size = ["300 mm", "300 mm"]
elements = 600
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[tool]]
name = "punch"
mesh = "punch.stl"
motion = { displacement = "-20 mm" }
[[tool]]
name = "die"
mesh = "die.stl"
[[tool]]
name = "holder"
mesh = "holder.stl"
force = "-35 N"
[time]
end = "20 ms"
[output]
frames = 4
history = 20
)";
  }

  /// A finished run, its results in a folder of that name.
  Summary form(const std::string& name, int threads, const std::vector<std::string>& overrides = {}) const
  {
    const RunOutcome outcome =
        run(read_case(directory / "case.toml", overrides), {directory / name, threads, true});
    EXPECT_EQ(outcome.code, ExitCode::done) << outcome.summary.message;
    return outcome.summary;
  }
  [[nodiscard]] std::vector<double> values(const std::string& name, const std::string& dataset) const
  {
    const hdf5::File file = hdf5::File::open(directory / name / "results.h5", hdf5::File::Mode::read);
    return hdf5::read_numbers(hdf5::open_dataset(file.id(), dataset));
  }
};

} // namespace towform
