#pragma once
#include "contact/shapes.hpp"
#include "output/temporary_directory.hpp"
#include "towform/case.hpp"
#include "towform/run.hpp"
#include <algorithm>
#include <fstream>

namespace towform {

/// A small press as a user would write it: a ball comes down on the middle of a 60 x 60 mm sheet that lies on
/// a block each side. Runs in milliseconds.
class Press : public TemporaryDirectory {
protected:
  Press()
  {
    // The sheet's mid-plane is z = 0, its faces at +-0.5 mm; the ball's lowest point starts on the upper one.
    SurfaceMesh ball = test::sphere(0.02, 8);
    for (Vec3& p : ball.points) p.z += 0.0205;
    write_stl(directory / "ball.stl", ball, "ball");
    write_stl(directory / "left.stl", test::box({-0.05, -0.05, -0.03}, {-0.02, 0.05, -0.0005}), "left");
    write_stl(directory / "right.stl", test::box({0.02, -0.05, -0.03}, {0.05, 0.05, -0.0005}), "right");
  }

  /// Reads the press with keys replaced or added.
  [[nodiscard]] Case read(const std::vector<std::string>& overrides = {}) const
  {
    std::ofstream(directory / "press.toml") << text;
    return read_case(directory / "press.toml", overrides);
  }
  [[nodiscard]] RunOutcome form(const std::vector<std::string>& overrides = {}) const
  {
    return run(read(overrides), {out, 1, true, true});
  }

  std::string text = R"(title = "Press"
[blank]
size = ["60 mm", "60 mm"]
elements = 72
thickness = "1 mm"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
[[tool]]
name = "ball"
mesh = "ball.stl"
motion = { displacement = "-5 mm" }
[[tool]]
name = "left"
mesh = "left.stl"
[[tool]]
name = "right"
mesh = "right.stl"
[time]
end = "5 ms"
[output]
frames = 2
history = 10
)";
  std::filesystem::path out = directory / "out";
};

} // namespace towform
