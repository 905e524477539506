#include "solver/statics_recorder.hpp"
#include "solver/measure.hpp"
#include "solver/run_files.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace towform {

namespace {

constexpr std::size_t per_element = QuadrilateralMembrane::points_per_element;

std::size_t central_element(const QuadrilateralGrid& g)
{
  const auto i = static_cast<std::size_t>(g.nx / 2), j = static_cast<std::size_t>(g.ny / 2);
  return i + static_cast<std::size_t>(g.nx) * j;
}

std::vector<std::string> history_columns(const StaticsModel& model)
{
  std::vector<std::string> columns{"time_s", "step", "dt_s"};
  for (const char* pattern : {"force_{}_N", "position_{}_m"})
    for (const HeldGroup& g : model.groups)
      if (g.motion) columns.push_back(fmt::format(fmt::runtime(pattern), g.name));
  for (const auto& [kind, value] : listed(Energies{})) columns.push_back(fmt::format("energy_{}_J", kind));
  for (const char* name : {"energy_error", "shear_angle_max_deg", "fibre_strain_p99",
                           "shear_angle_centre_deg", "shear_rate_centre_rad_per_s", "newton_iterations"})
    columns.emplace_back(name);
  return columns;
}

double velocity_scale(const FabricLaw& law)
{
  const auto* incremental = std::get_if<IncrementalLaw>(&law);
  return incremental ? incremental->velocity_scale : 1.0;
}

/// Means over an element's points.
struct ElementMean {
  double angle = 0.0, rate = 0.0, force = 0.0, strain1 = 0.0, strain2 = 0.0, thickness = 0.0;
  Eigen::Vector3d f1 = Eigen::Vector3d::Zero(), f2 = Eigen::Vector3d::Zero();

  ElementMean(const QuadrilateralMembrane& m, const StaticsState& s, std::size_t element)
  {
    for (std::size_t k = per_element * element; k < per_element * (element + 1); ++k) {
      constexpr double share = 1.0 / per_element;
      const StructuralNet net = m.points[k].net(m.elements[element], s.position);
      angle += share * s.shear[k].angle;
      rate += share * s.shear[k].rate;
      force += share * s.shear[k].force;
      strain1 += share * (net.lambda1 - 1.0);
      strain2 += share * (net.lambda2 - 1.0);
      thickness += share * m.thickness * std::sqrt(1.0 - m.reference_sine * m.reference_sine) /
                   (net.lambda1 * net.lambda2 * std::sqrt(1.0 - net.sine * net.sine));
      f1 += net.f1;
      f2 += net.f2;
    }
    f1.normalize();
    f2.normalize();
  }
};

Vec3 vec3(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

} // namespace

Frame make_frame(const StaticsCase& problem, double temperature, const StaticsState& s)
{
  const QuadrilateralMembrane& membrane = problem.model.membrane;
  const ShearCurves& curves = *problem.material.curves;
  const double scale = velocity_scale(membrane.law);
  Frame f;
  f.time = s.time;
  f.position = s.position;
  f.velocity = s.velocity;
  f.contact_pressure.assign(s.position.size(), 0.0);
  for (std::size_t e = 0; e < membrane.elements.size(); ++e) {
    const ElementMean mean(membrane, s, e);
    for (int half = 0; half < 2; ++half) {
      f.shear_angle.push_back(mean.angle * to_degrees);
      f.shear_rate.push_back(mean.rate);
      f.curve_index.push_back(curves.next_higher(mean.rate * scale));
      f.curve_position.push_back(curves.position(mean.rate * scale));
      f.shear_force.push_back(mean.force);
      f.fibre_1.push_back(vec3(mean.f1));
      f.fibre_2.push_back(vec3(mean.f2));
      f.fibre_strain.push_back({mean.strain1, mean.strain2});
      f.curvature.push_back({0.0, 0.0}); // the sheet stays flat
      f.thickness.push_back(mean.thickness);
      f.temperature.push_back(temperature);
    }
  }
  return f;
}

Energies energy_account(const StaticsModel& model, const StaticsState& s)
{
  Energies e;
  e.yarn = model.membrane.yarn_energy(s.position);
  e.shear_dissipated = s.shear_dissipated;
  e.shear_elastic = s.shear_work - s.shear_dissipated;
  e.external = s.external_work;
  return e;
}

StaticsRecorder::StaticsRecorder(const Case& c, const StaticsCase& problem,
                                 const std::filesystem::path& directory, Record& record)
    : case_(c), problem_(problem), record_(record), directory_(directory),
      central_(central_element(problem.grid)),
      results_(open_results(c, directory, problem.grid.triangles(), record)),
      history_(open_history(directory, history_columns(problem.model), record))
{
  record_.summary.elements = static_cast<std::int64_t>(problem.grid.elements.size());
  record_.summary.nodes = static_cast<std::int64_t>(problem.grid.points.size());
}

void StaticsRecorder::watch(const StaticsState& s, const NewtonReport& report)
{
  record_.iterations += report.iterations;
  record_.summary.step_min_s = s.step == 1 ? s.last_dt : std::min(record_.summary.step_min_s, s.last_dt);
  record_.summary.step_max_s = std::max(record_.summary.step_max_s, s.last_dt);
  for (std::size_t i = 0; i < s.group_force.size(); ++i)
    if (problem_.model.groups[i].motion)
      record_.summary.punch_force_max_N =
          std::max(record_.summary.punch_force_max_N, std::abs(s.group_force[i]));
}

void StaticsRecorder::measure(const StaticsState& s)
{
  const QuadrilateralMembrane& membrane = problem_.model.membrane;
  std::vector<double> shear, strain, compression;
  for (std::size_t e = 0; e < membrane.elements.size(); ++e) {
    const ElementMean mean(membrane, s, e);
    shear.push_back(std::abs(mean.angle));
    strain.push_back(std::max(std::abs(mean.strain1), std::abs(mean.strain2)));
    compression.push_back(std::max({0.0, -mean.strain1, -mean.strain2}));
  }
  const FieldExtremes extremes =
      field_extremes(field_tail(shear), field_tail(strain, much_strain), field_tail(compression, much_compression));
  extremes.tell(record_.summary);
  most_strained_ = extremes.most_strained;
  energies_ = energy_account(problem_.model, s);
  record_.summary.steps = s.step;
  record_.summary.simulated_time_s = s.time;
  record_.summary.energy_error = energies_.error();
  record_.summary.energies_J = listed(energies_);
}

void StaticsRecorder::check_gates(const StaticsState& s) const
{
  const auto stop = [&](const std::string& what) {
    throw RunStopped(ExitCode::stability_gate,
                     fmt::format("stopped at t = {:.6g} ms, increment {}: {}", 1e3 * s.time, s.step, what));
  };
  constexpr double from = 0.25; // of the run: before, the energies are small
  if (s.time >= from * case_.time.end && energies_.error() > case_.gates.energy_error)
    stop(fmt::format("the energy account is off by {:.2f} % of the external work, limit gates.energy_error = "
                     "{:.2f} %",
                     100.0 * energies_.error(), 100.0 * case_.gates.energy_error));
  if (record_.summary.fibre_strain_p99 > case_.gates.yarn_strain)
    stop(
        fmt::format("1 % of the elements strain their yarns by more than {:.2f} %, limit gates.yarn_strain = "
                    "{:.2f} %; the worst is element {} with {:.2f} %",
                    100.0 * record_.summary.fibre_strain_p99, 100.0 * case_.gates.yarn_strain, most_strained_,
                    100.0 * record_.summary.fibre_strain_max));
}

void StaticsRecorder::history(const StaticsState& s)
{
  measure(s);
  const StaticsModel& model = problem_.model;
  std::vector<double> row{s.time, static_cast<double>(s.step), s.last_dt};
  for (std::size_t i = 0; i < model.groups.size(); ++i)
    if (model.groups[i].motion) row.push_back(s.group_force[i]);
  for (const HeldGroup& g : model.groups)
    if (g.motion) row.push_back(g.motion->displacement(s.time));
  for (const auto& [kind, value] : listed(energies_)) row.push_back(value);
  const ElementMean centre(model.membrane, s, central_);
  row.insert(row.end(),
             {energies_.error(), record_.summary.shear_angle_max_deg, record_.summary.fibre_strain_p99,
              centre.angle * to_degrees, centre.rate, static_cast<double>(record_.iterations)});
  history_->append(row);
  ++record_.rows;
  record_.iterations = 0;
  check_gates(s);
}

void StaticsRecorder::frame(const StaticsState& s, Progress& progress)
{
  results_->append(make_frame(problem_, case_.material.temperature, s));
  ++record_.frames;
  std::string forces;
  for (std::size_t i = 0; i < s.group_force.size(); ++i)
    if (const HeldGroup& g = problem_.model.groups[i]; g.motion)
      forces += fmt::format("  {} {:.3f} N", g.name, s.group_force[i]);
  progress.line(
      fmt::format("t {:10.3f} ms  increment {:6d}  dt {:.3g} ms  shear max {:5.2f} deg{}  work {:.4g} J  "
                  "energy error {:.2f} %",
                  1e3 * s.time, s.step, 1e3 * s.last_dt, record_.summary.shear_angle_max_deg, forces,
                  energies_.external, 100.0 * energies_.error()));
}

void StaticsRecorder::finish()
{
  write_summary(directory_, record_.summary);
  results_->finish(record_.summary.status == "done" ? "done" : record_.summary.message); // last: resume looks at this
}

} // namespace towform
