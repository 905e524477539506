#pragma once
#include "towform/results.hpp"
#include <cmath>
#include <numbers>

/// A made-up forming: a square sheet of 300 mm whose middle rises into a dome, with the shear of an
/// inextensible net on it (large on the bias diagonals, none along the yarns). For trying what is written and
/// drawn.
namespace towform::dome {

constexpr double size = 0.3;      ///< edge of the sheet [m]
constexpr double height = 0.08;   ///< of the finished dome [m]
constexpr double end_time = 0.06; ///< [s]

inline SurfaceMesh sheet(int squares)
{
  SurfaceMesh mesh;
  for (int j = 0; j <= squares; ++j)
    for (int i = 0; i <= squares; ++i)
      mesh.points.push_back({size * (double(i) / squares - 0.5), size * (double(j) / squares - 0.5), 0.0});
  const int row = squares + 1;
  for (int j = 0; j < squares; ++j)
    for (int i = 0; i < squares; ++i) {
      const int a = j * row + i;
      mesh.triangles.push_back({a, a + 1, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + row});
    }
  return mesh;
}

/// The sheet after a part of the stroke, 0 to 1.
inline Frame frame(const SurfaceMesh& mesh, double stroke)
{
  const double radius = 0.11;
  Frame f;
  f.time = stroke * end_time;
  for (const Vec3& p : mesh.points) {
    const double r = std::min(std::hypot(p.x, p.y) / radius, 1.0);
    const double bump = height * stroke * 0.5 * (1.0 + std::cos(std::numbers::pi * r));
    const double pull = 1.0 - 0.12 * stroke * stroke * (1.0 + 0.5 * std::cos(4.0 * std::atan2(p.y, p.x)));
    f.position.push_back({pull * p.x, pull * p.y, bump});
    f.velocity.push_back({0.0, 0.0, bump / (end_time * std::max(stroke, 1e-3))});
    f.clearance.push_back(2e-3 * (1.0 - r));
    f.contact_pressure.push_back(stroke * 2e4 * (r < 0.5 ? 1.0 - 2.0 * r : 0.0));
  }
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vec3 centre = (1.0 / 3.0) * (a + b + c);
    const double r = std::hypot(centre.x, centre.y) / radius;
    const double shear =
        46.0 * stroke * std::sin(2.0 * std::atan2(centre.y, centre.x)) * r * r * std::exp(1.0 - r * r);
    f.shear_angle.push_back(shear);
    f.shear_rate.push_back(shear * std::numbers::pi / 180.0 / end_time);
    f.curve_position.push_back(1.0 + std::abs(f.shear_rate.back()));
    f.curve_index.push_back(static_cast<std::int32_t>(f.curve_position.back()));
    f.shear_force.push_back(3.0 * shear);
    const double angle = shear * std::numbers::pi / 180.0;
    f.fibre_1.push_back({1.0, 0.0, 0.0});
    f.fibre_2.push_back({std::sin(angle), std::cos(angle), 0.0});
    f.fibre_strain.push_back({1e-3 * stroke * centre.x / size, -2e-3 * stroke * centre.y / size});
    f.curvature.push_back({10.0 * stroke * std::cos(r), -5.0 * stroke * r});
    f.thickness.push_back(1e-3 / std::cos(angle));
    f.temperature.push_back(463.15);
  }
  return f;
}

inline Provenance provenance()
{
  return {.version = "0.1.0",
          .git_hash = "0123456789ab",
          .flags = "GNU Release",
          .title = "Dome, 0/90 \u2713",
          .case_text = "title = \"Dome\"\n",
          .resolved_case = "title = \"Dome\"\n[time]\nend = 0.06\n",
          .input_sha256 = {{"cases/dome.toml", std::string(64, 'a')},
                           {"meshes/a punch.stl", std::string(64, 'b')}}};
}

} // namespace towform::dome
