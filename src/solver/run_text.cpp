#include "solver/run_text.hpp"
#include "parallel/parallel.hpp"
#include "solver/estimate.hpp"
#include "solver/mesh_warnings.hpp"
#include "solver/statics_run.hpp"
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace towform {

namespace {

/// Above this the sheet's inertia shapes the answer, as it does in a fast press: the user should know.
constexpr double inertia_matters = 0.1;

/// Above this fraction of the elements with yarns shortened by more than 0.5 % the answer hides wrinkles: a
/// real yarn would have buckled at a fraction of that strain, where ours is merely softer.
constexpr double compression_matters = 0.01;

} // namespace

std::string headline(const Case& c, const Model& model)
{
  return fmt::format("{}: {} elements, {} nodes, about {:.0f} steps of {:.2f} us, {} thread{}",
                     c.title.empty() ? "untitled" : c.title, model.membrane.triangles.size(),
                     model.mass.size(), std::ceil(c.time.end / model.first_step), 1e6 * model.first_step,
                     threads(), threads() == 1 ? "" : "s");
}

std::string closing(const Summary& s, const std::filesystem::path& directory)
{
  std::string phases;
  for (const auto& [name, seconds] : s.phases_s)
    phases += fmt::format("{}{} {:.2f}", phases.empty() ? "" : ", ", name, seconds);
  std::string inertia;
  if (s.kinetic_to_internal_max > inertia_matters)
    inertia =
        fmt::format("inertia matters: kinetic energy reached {:.0f} % of internal and dissipated energy in "
                    "the second half of the run\n",
                    100.0 * s.kinetic_to_internal_max);
  std::string wrinkles;
  if (s.fibre_compression_over_half_percent > compression_matters)
    wrinkles = fmt::format("compression hides wrinkles: {:.1f} % of the elements shorten their yarns by more "
                           "than 0.5 % (up to {:.1f} %), where a real sheet buckles; look at fibre_strain, "
                           "curvature and clearance\n",
                           100.0 * s.fibre_compression_over_half_percent, 100.0 * s.fibre_compression_max);
  return fmt::format(
      "{} in {:.2f} s: {} steps, {:.1f} ns per element-step (in s: {})\n"
      "  shear angle    {:9.1f} deg   99 % of the elements below {:.1f} deg\n"
      "  draw-in x      {:9.1f} mm    y {:.1f} mm, corner {:.1f} mm\n"
      "  driving force  {:9.1f} N     the largest\n"
      "  energy error   {:9.2f} %     of the external work\n"
      "  kinetic energy {:9.1f} %     of internal and dissipated, the largest in the second half\n"
      "  penetration    {:9.3f} mm    the deepest\n"
      "  yarn strain    {:9.2f} %     99 % of the elements below {:.2f} %\n"
      "{}{}wrote {}",
      s.status, s.wall_time_s, s.steps, s.ns_per_element_step, phases, s.shear_angle_max_deg,
      s.shear_angle_p99_deg, s.draw_in_x_mid_mm, s.draw_in_y_mid_mm, s.draw_in_corner_mm, s.punch_force_max_N,
      100.0 * s.energy_error, 100.0 * s.kinetic_to_internal_max, s.penetration_max_mm,
      100.0 * s.fibre_strain_max, 100.0 * s.fibre_strain_p99, inertia, wrinkles,
      (directory / "results.h5, results.xdmf, history.csv, summary.json, run.log").string());
}

std::string describe_run(const Case& c)
{
  if (c.solver == SolverKind::implicit) return describe_statics(c);
  const Model model = build_model(c);
  const auto direction = [](const Vec3& v) { return std::atan2(v.y, v.x) * 180.0 / M_PI; };
  std::string text = headline(c, model) + '\n';
  text += fmt::format("sheet {:.1f} g, added by mass scaling {:.2f} %; warp at {:.1f} deg, weft at {:.1f} "
                      "deg, curves fit to {:.2f} %\n",
                      1e3 * model.mirror_factor * std::accumulate(model.mass.begin(), model.mass.end(), 0.0),
                      100.0 * model.added_mass_fraction, direction(model.blank.warp),
                      direction(model.blank.weft), 100.0 * model.material.curves->fit_error);
  text += estimate_text(estimate(c, model, threads()));
  text += mesh_warnings(c, model);
  for (const Bending& bending : model.bending)
    text += fmt::format("bending stiffness {:.3g} / {:.3g} mN m (warp / weft{})\n",
                        1e3 * bending.warp.stiffness(), 1e3 * bending.weft.stiffness(),
                        c.material.bending_table.empty() ? "" : ", the table's steepest");
  for (const Tool& tool : model.tools) {
    const Vec3 low = tool.surface.lowest(), high = tool.surface.highest();
    const std::string drive =
        tool.force    ? fmt::format("pushed with {} N, {} kg", *tool.force, tool.mass)
        : tool.motion ? fmt::format("moves {:.4g} mm by the end", 1e3 * tool.motion->displacement(c.time.end))
                      : "stands";
    text += fmt::format("tool '{}': {} facets, x {:.1f} to {:.1f}, y {:.1f} to {:.1f}, z {:.1f} to {:.1f} "
                        "mm, friction {}, {}\n",
                        tool.name, tool.surface.mesh().triangles.size(), 1e3 * low.x, 1e3 * high.x,
                        1e3 * low.y, 1e3 * high.y, 1e3 * low.z, 1e3 * high.z, tool.friction, drive);
  }
  for (const Boundary& b : model.boundaries)
    text += fmt::format(
        "boundary '{}': holds {} nodes, {}\n", b.name, b.nodes.size(),
        b.motion ? fmt::format("moves {:.4g} mm by the end", 1e3 * b.motion->displacement(c.time.end))
                 : "clamped");
  return text;
}

} // namespace towform
