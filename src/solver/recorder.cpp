#include "solver/recorder.hpp"
#include "solver/frame_fields.hpp"
#include "solver/run_files.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace towform {

namespace {

std::vector<std::string> history_columns(const Model& model)
{
  std::vector<std::string> columns{"time_s", "step", "dt_s"};
  for (const Tool& tool : model.tools) columns.push_back(fmt::format("force_{}_N", tool.name));
  for (const Boundary& b : model.boundaries)
    if (b.motion) columns.push_back(fmt::format("force_{}_N", b.name));
  for (const Tool& tool : model.tools) columns.push_back(fmt::format("position_{}_m", tool.name));
  for (const Boundary& b : model.boundaries)
    if (b.motion) columns.push_back(fmt::format("position_{}_m", b.name));
  for (const auto& [kind, value] : listed(Energies{})) columns.push_back(fmt::format("energy_{}_J", kind));
  for (const char* name : {"energy_error", "kinetic_to_internal", "draw_in_x_mid_mm", "draw_in_y_mid_mm",
                           "draw_in_corner_mm", "shear_angle_max_deg", "fibre_strain_p99", "penetration_mm"})
    columns.emplace_back(name);
  return columns;
}

double kinetic_to_internal(const Energies& e) { return e.internal() > 0.0 ? e.kinetic / e.internal() : 0.0; }

} // namespace

Recorder::Recorder(const Case& c, const Model& model, ShownCurvature curvature, const std::filesystem::path& directory,
                   Record& record)
    : case_(c), model_(model), curvature_(std::move(curvature)), record_(record), directory_(directory), gauge_(model.blank),
      results_(open_results(c, directory, model.blank.mesh, record)),
      history_(open_history(directory, history_columns(model), record))
{
  record_.summary.elements = static_cast<std::int64_t>(model.membrane.triangles.size());
  record_.summary.nodes = static_cast<std::int64_t>(model.mass.size());
  record_.summary.added_mass_fraction = model.added_mass_fraction;
  if (record_.rows == 0) record_.summary.step_min_s = record_.summary.step_max_s = model.first_step;
}

void Recorder::watch(const System& s, double dt)
{
  for (std::size_t i = 0; i < s.contacts.size(); ++i) {
    const ContactState& c = s.contacts[i];
    if (c.penetration <= record_.deepest.depth) continue;
    const double moved = std::abs(s.tools[model_.contacts[i].tool].velocity) * dt;
    record_.deepest = {c.penetration, static_cast<int>(i), c.deepest_node, moved, s.sheet.time};
  }
  for (std::size_t i = 0; i < s.tools.size(); ++i)
    if (model_.tools[i].motion)
      record_.summary.punch_force_max_N = std::max(
          record_.summary.punch_force_max_N, std::abs(dot(s.tools[i].reaction, model_.tools[i].direction)));
  record_.summary.step_min_s = std::min(record_.summary.step_min_s, dt);
  record_.summary.step_max_s = std::max(record_.summary.step_max_s, dt);
}

void Recorder::measure(const System& s)
{
  energies_ = energy_account(model_, s);
  extremes_ = field_extremes(model_.membrane, s);
  draw_in_ = gauge_.measure(s);
  record_.summary.steps = s.sheet.step;
  record_.summary.simulated_time_s = s.sheet.time;
  record_.summary.energy_error = energies_.error();
  if (s.sheet.time >= 0.5 * case_.time.end)
    record_.summary.kinetic_to_internal_max =
        std::max(record_.summary.kinetic_to_internal_max, kinetic_to_internal(energies_));
  extremes_.tell(record_.summary);
  record_.summary.draw_in_x_mid_mm = 1e3 * draw_in_.x_mid;
  record_.summary.draw_in_y_mid_mm = 1e3 * draw_in_.y_mid;
  record_.summary.draw_in_corner_mm = 1e3 * draw_in_.corner;
  record_.summary.penetration_max_mm =
      std::max(record_.summary.penetration_max_mm, 1e3 * record_.deepest.depth);
  record_.summary.energies_J = listed(energies_);
}

void Recorder::history(const System& s)
{
  measure(s);
  std::vector<double> row{s.sheet.time, static_cast<double>(s.sheet.step), s.sheet.last_dt};
  for (std::size_t i = 0; i < s.tools.size(); ++i)
    row.push_back(dot(s.tools[i].reaction, model_.tools[i].direction));
  for (std::size_t i = 0; i < s.boundaries.size(); ++i)
    if (model_.boundaries[i].motion) row.push_back(model_.boundaries[i].whole_edge * s.boundaries[i].force);
  for (const ToolState& tool : s.tools) row.push_back(tool.displacement);
  for (std::size_t i = 0; i < s.boundaries.size(); ++i)
    if (model_.boundaries[i].motion) row.push_back(s.boundaries[i].displacement);
  for (const auto& [kind, value] : listed(energies_)) row.push_back(value);
  row.insert(row.end(), {energies_.error(), kinetic_to_internal(energies_), 1e3 * draw_in_.x_mid,
                         1e3 * draw_in_.y_mid, 1e3 * draw_in_.corner, record_.summary.shear_angle_max_deg,
                         extremes_.strain_p99, 1e3 * record_.deepest.depth});
  history_->append(row);
  ++record_.rows;
  const DeepestContact deepest = std::exchange(record_.deepest, {});
  check_gates(case_.gates, model_, s, energies_, extremes_, deepest, s.sheet.time / case_.time.end,
              kinetic_to_internal(energies_));
}

void Recorder::frame(const System& s, Progress& progress)
{
  results_->append(s.sheet.time, !model_.tools.empty(),
                   [&](std::string_view field) { return frame_field(model_, s, curvature_.get(), field); });
  ++record_.frames;
  std::string forces;
  for (std::size_t i = 0; i < s.tools.size(); ++i)
    if (model_.tools[i].motion)
      forces += fmt::format("  {} {:.1f} N", model_.tools[i].name,
                            dot(s.tools[i].reaction, model_.tools[i].direction) + 0.0); // none is not -0
  for (std::size_t i = 0; i < s.boundaries.size(); ++i)
    if (model_.boundaries[i].motion)
      forces += fmt::format("  {} {:.2f} N", model_.boundaries[i].name,
                            model_.boundaries[i].whole_edge * s.boundaries[i].force);
  progress.line(fmt::format(
      "t {:7.3f} ms  step {:6d}  dt {:.2f} us  shear max {:4.1f} deg{}  work {:.3f} J  kinetic {:.3f} J  "
      "energy error {:.2f} %",
      1e3 * s.sheet.time, s.sheet.step, 1e6 * s.sheet.last_dt, record_.summary.shear_angle_max_deg, forces,
      energies_.external, energies_.kinetic, 100.0 * energies_.error()));
}

void Recorder::last_frame(const System& s, Progress& progress)
{
  const bool finite = std::all_of(s.sheet.position.begin(), s.sheet.position.end(), is_finite);
  if (!finite) return; // the frames before are what can be used
  measure(s);
  frame(s, progress);
}

void Recorder::finish()
{
  write_summary(directory_, record_.summary);
  results_->finish(record_.summary.status == "done" ? "done" : record_.summary.message); // last: resume looks at this
}

} // namespace towform
