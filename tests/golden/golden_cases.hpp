#pragma once
#include "../verification/hemisphere_case.hpp"
#include "output/checkpoint_file.hpp"
#include "output/sha256.hpp"
#include <map>

namespace towform {

/// Four short cases that together have every kind of state: a press whose holder is pushed by a force; a
/// mirrored press with bending, gravity and damping; yarns across the mesh between grips; quasi-static
/// quadrilaterals.
class Golden : public CoarseHemisphere {
protected:
  struct Short {
    const char* name;
    std::string text;
    std::vector<std::string> overrides;
  };
  [[nodiscard]] std::vector<Short> cases() const
  {
    const std::string press = text_of(directory / "case.toml");
    const std::vector<std::string> stroke{"tool.punch.motion.displacement=-2 mm", "time.end=2 ms",
                                          "output.history=9", "output.frames=3"};
    std::vector<std::string> bent = stroke;
    bent.insert(bent.end(),
                {"material.law=incremental", "material.bending_stiffness=2 mN m",
                 "load.gravity=[0, 0, -9.81]", "load.pressure=10 Pa", "gates.kinetic_to_internal=1000",
                 "time.mass_damping=10", "blank.symmetry=quarter"});
    const std::string sheet = R"(
[blank]
size = ["100 mm", "100 mm"]
elements = 300
thickness = "1 mm"
fibre_angle = "45 deg"
[material]
card = "gf_pp_twill"
temperature = "190 degC"
)";
    const std::string grips = sheet + R"(
[[boundary]]
name = "foot"
edge = "bottom"
[[boundary]]
name = "head"
edge = "top"
motion = { axis = "y", displacement = "1 mm", profile = "smooth" }
[time]
end = "2 ms"
[output]
frames = 3
history = 9
)";
    const std::string frame = sheet + R"(
[[boundary]]
name = "frame"
kind = "picture_frame"
motion = { displacement = "10 mm" }
[time]
end = "10 s"
[output]
frames = 3
history = 9
)";
    return {
        {"press", press, stroke},
        {"bent", press, bent},
        {"grips", grips, {}},
        {"frame",
         frame,
         {"solver=implicit", "blank.element=quadrilateral", "blank.elements=16", "blank.fibre_angle=0 deg"}}};
  }

  [[nodiscard]] Case read(const Short& c) const
  {
    const std::filesystem::path path = directory / fmt::format("{}.toml", c.name);
    std::ofstream(path) << c.text;
    return read_case(path, c.overrides);
  }

  /// SHA-256 of all that the checkpoint of a run holds, but for wall times.
  [[nodiscard]] static std::string state_hash(const std::filesystem::path& run)
  {
    const hdf5::File file = hdf5::File::open(checkpoint_path(run), hdf5::File::Mode::read);
    const hdf5::Group state = hdf5::open_group(file.id(), "state");
    Sha256 hash;
    for (const std::string& name : hdf5::link_names(state.id())) {
      if (name == "phases" || name == "output" || name == "stepping" || name.ends_with("wall_time_s"))
        continue;
      const std::vector<double> numbers = hdf5::read_numbers(hdf5::open_dataset(state.id(), name));
      hash.add({reinterpret_cast<const unsigned char*>(name.data()), name.size()});
      hash.add({reinterpret_cast<const unsigned char*>(numbers.data()), numbers.size() * sizeof(double)});
    }
    return hash.digest();
  }

  /// Every number of every frame.
  [[nodiscard]] static std::map<std::string, std::vector<double>> frames_of(const std::filesystem::path& run)
  {
    std::map<std::string, std::vector<double>> all;
    const hdf5::File file = hdf5::File::open(run / "results.h5", hdf5::File::Mode::read);
    for (const std::string& frame : hdf5::link_names(hdf5::open_group(file.id(), "frames").id())) {
      const hdf5::Group group = hdf5::open_group(file.id(), "frames/" + frame);
      all[frame] = {hdf5::number_attribute(group.id(), "time")};
      for (const std::string& name : hdf5::link_names(group.id()))
        all[frame + "/" + name] = hdf5::read_numbers(hdf5::open_dataset(group.id(), name));
    }
    return all;
  }
};

} // namespace towform
