#include "temporary_directory.hpp"
#include "towform/error.hpp"
#include "towform/results.hpp"
#include <limits>
#include <nlohmann/json.hpp>

namespace towform {

namespace {

using SummaryFile = TemporaryDirectory;
using Json = nlohmann::ordered_json;

Summary numbered()
{
  Summary s;
  s.status = "stopped";
  s.message = "element 3: \"inverted\" \xff"; // not UTF-8 either: a file's name may be anything
  s.elements = 1;
  s.nodes = 2;
  s.steps = 3'000'000'000;
  s.simulated_time_s = 4.5;
  s.wall_time_s = 5.5;
  s.threads = 6;
  s.ns_per_element_step = 7.5;
  s.step_min_s = 8.5;
  s.step_max_s = 9.5;
  s.energy_error = 10.5;
  s.kinetic_to_internal_max = 11.5;
  s.shear_angle_max_deg = 12.5;
  s.shear_angle_p99_deg = 13.5;
  s.fibre_strain_max = 14.5;
  s.fibre_strain_p99 = 15.5;
  s.fibre_strain_over_2_percent = 16.5;
  s.fibre_compression_max = 24.5;
  s.fibre_compression_p99 = 25.5;
  s.fibre_compression_over_half_percent = 26.5;
  s.draw_in_x_mid_mm = 17.5;
  s.draw_in_y_mid_mm = 18.5;
  s.draw_in_corner_mm = 19.5;
  s.punch_force_max_N = 20.5;
  s.penetration_max_mm = std::numeric_limits<double>::quiet_NaN();
  s.added_mass_fraction = std::numeric_limits<double>::infinity();
  s.energies_J = {{"yarn", 21.5}, {"kinetic", 22.5}};
  s.phases_s = {{"contact", 23.5}};
  return s;
}

} // namespace

TEST_F(SummaryFile, HasEveryFigureUnderItsName)
{
  write_summary(directory, numbered());
  const std::string expected = R"({
  "status": "stopped",
  "message": "element 3: \"inverted\" )"
                               "\xEF\xBF\xBD"
                               R"(",
  "elements": 1,
  "nodes": 2,
  "steps": 3000000000,
  "simulated_time_s": 4.5,
  "wall_time_s": 5.5,
  "threads": 6,
  "ns_per_element_step": 7.5,
  "step_min_s": 8.5,
  "step_max_s": 9.5,
  "energy_error": 10.5,
  "kinetic_to_internal_max": 11.5,
  "shear_angle_max_deg": 12.5,
  "shear_angle_p99_deg": 13.5,
  "fibre_strain_max": 14.5,
  "fibre_strain_p99": 15.5,
  "fibre_strain_over_2_percent": 16.5,
  "fibre_compression_max": 24.5,
  "fibre_compression_p99": 25.5,
  "fibre_compression_over_half_percent": 26.5,
  "draw_in_mm": {
    "x_mid": 17.5,
    "y_mid": 18.5,
    "corner": 19.5
  },
  "punch_force_max_N": 20.5,
  "penetration_max_mm": null,
  "added_mass_fraction": null,
  "energies_J": {
    "yarn": 21.5,
    "kinetic": 22.5
  },
  "phases_s": {
    "contact": 23.5
  }
}
)";
  EXPECT_EQ(text_of(directory / "summary.json"), expected);
  EXPECT_TRUE(Json::accept(expected));
}

TEST_F(SummaryFile, IsReplacedAndLeavesNoTemporaryFile)
{
  write_summary(directory, numbered());
  write_summary(directory, {});
  EXPECT_EQ(Json::parse(text_of(directory / "summary.json"))["status"], "running");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

TEST_F(SummaryFile, SaysWhyItCannotBeWritten)
{
  std::filesystem::create_directories(directory / "summary.json/in the way");
  const std::string message = message_of<FileError>([&] { write_summary(directory, {}); });
  EXPECT_EQ(message, (directory / "summary.json").string() + ": cannot be written: Is a directory");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

} // namespace towform
