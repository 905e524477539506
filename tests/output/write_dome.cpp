// write_dome DIR [SQUARES] [FRAMES]: results of the made-up dome and a history, to try the readers on.
#include "dome.hpp"
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fmt/format.h>

int main(int argc, char** argv)
try {
  using namespace towform;
  if (argc < 2) return 2;
  const std::filesystem::path directory = argv[1];
  const int squares = argc > 2 ? std::atoi(argv[2]) : 40;
  const int frames = argc > 3 ? std::atoi(argv[3]) : 6;
  const SurfaceMesh mesh = dome::sheet(squares);
  ResultsWriter results(directory, mesh, dome::provenance());
  HistoryWriter history(directory / "history.csv",
                        {"time_s", "step", "dt_s", "force_punch_N", "force_holder_N", "position_punch_m",
                         "energy_yarn_J", "energy_shear_dissipated_J", "energy_kinetic_J", "energy_error"});
  double slowest = 0.0;
  for (int i = 0; i < frames; ++i) {
    const double stroke = frames > 1 ? double(i) / (frames - 1) : 1.0;
    const Frame frame = dome::frame(mesh, stroke);
    const auto start = std::chrono::steady_clock::now();
    results.append(frame);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    slowest = std::max(slowest, taken.count());
    history.append({frame.time, 2000.0 * i, 5e-6, 120.0 * stroke * stroke, -35.0, -0.06 * stroke,
                    0.4 * stroke * stroke, 1.1 * stroke * stroke * stroke, 0.05 * stroke * (1.0 - stroke),
                    1e-3 * stroke});
  }
  results.finish("done");
  Summary summary;
  summary.status = "done";
  summary.elements = static_cast<std::int64_t>(mesh.triangles.size());
  write_summary(directory, summary);
  fmt::print("{} frames of {} elements, slowest {:.1f} ms, {:.1f} MB\n{}", frames, mesh.triangles.size(),
             1e3 * slowest, 1e-6 * static_cast<double>(std::filesystem::file_size(directory / "results.h5")),
             describe_results(directory / "results.h5"));
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
