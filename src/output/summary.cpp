#include "output/text_file.hpp"
#include "towform/results.hpp"
#include <nlohmann/json.hpp>

namespace towform {

namespace {

using Json = nlohmann::ordered_json;

Json object(const std::vector<std::pair<std::string, double>>& values)
{
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = value;
  return json;
}

} // namespace

void write_summary(const std::filesystem::path& directory, const Summary& s)
{
  const Json json = {
      {"status", s.status},
      {"message", s.message},
      {"elements", s.elements},
      {"nodes", s.nodes},
      {"steps", s.steps},
      {"simulated_time_s", s.simulated_time_s},
      {"wall_time_s", s.wall_time_s},
      {"threads", s.threads},
      {"ns_per_element_step", s.ns_per_element_step},
      {"step_min_s", s.step_min_s},
      {"step_max_s", s.step_max_s},
      {"energy_error", s.energy_error},
      {"kinetic_to_internal_max", s.kinetic_to_internal_max},
      {"shear_angle_max_deg", s.shear_angle_max_deg},
      {"shear_angle_p99_deg", s.shear_angle_p99_deg},
      {"fibre_strain_max", s.fibre_strain_max},
      {"fibre_strain_p99", s.fibre_strain_p99},
      {"fibre_strain_over_2_percent", s.fibre_strain_over_2_percent},
      {"fibre_compression_max", s.fibre_compression_max},
      {"fibre_compression_p99", s.fibre_compression_p99},
      {"fibre_compression_over_half_percent", s.fibre_compression_over_half_percent},
      {"draw_in_mm",
       {{"x_mid", s.draw_in_x_mid_mm}, {"y_mid", s.draw_in_y_mid_mm}, {"corner", s.draw_in_corner_mm}}},
      {"punch_force_max_N", s.punch_force_max_N},
      {"penetration_max_mm", s.penetration_max_mm},
      {"added_mass_fraction", s.added_mass_fraction},
      {"energies_J", object(s.energies_J)},
      {"phases_s", object(s.phases_s)},
  };
  make_directory(directory);
  // JSON knows no NaN and no infinity: dump() writes null for them.
  replace_file(directory / "summary.json", json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace towform
