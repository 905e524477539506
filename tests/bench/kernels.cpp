// Kernels of a step on one thread: build/release/tests/bench/towform_bench (target towform_bench).
#include "contact/shapes.hpp"
#include "contact/tool_surface.hpp"
#include "element/bent.hpp"
#include "element/sheet.hpp"
#include "parallel/parallel.hpp"
#include <benchmark/benchmark.h>

namespace towform {
namespace {

/// Corner forces of a sheet that shears at about 10 rad/s; ns per element in the column ns_per_item.
void membrane(benchmark::State& run, LawKind kind)
{
  set_threads(1);
  const Blank blank = test::blank(Pattern::diagonal, 0.0, 0.0, static_cast<int>(run.range(0)));
  const Membrane membrane(blank, YarnLaw{1e6, 0.1}, test::law(kind));
  State s = test::at_rest(membrane, blank.mesh.points);
  const double dt = 5e-6;
  double shear = 0.0;
  for (auto _ : run) {
    shear += 10.0 * dt;
    for (std::size_t n = 0; n < s.position.size(); ++n)
      s.position[n].x = blank.mesh.points[n].x + std::sin(shear) * blank.mesh.points[n].y;
    membrane_forces(membrane, s, dt);
    benchmark::DoNotOptimize(s.block_force.data());
    if (shear > 1.0) {
      run.PauseTiming();
      s = test::at_rest(membrane, blank.mesh.points);
      shear = 0.0;
      run.ResumeTiming();
    }
  }
  run.counters["ns_per_item"] = benchmark::Counter(static_cast<double>(run.iterations()) *
                                                       static_cast<double>(membrane.area.size()) * 1e-9,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(membrane, viscous, LawKind::viscous)->Arg(20000);
BENCHMARK_CAPTURE(membrane, incremental, LawKind::incremental)->Arg(20000);
BENCHMARK_CAPTURE(membrane, elastic, LawKind::elastic)->Arg(20000);

/// Bending forces of a sheet on a cylinder; ns per element in the column ns_per_item.
void bending(benchmark::State& run, Pattern pattern)
{
  set_threads(1);
  const Blank blank = test::blank(pattern, 0.0, 0.0, 20000);
  const Bending bending = test::bending_of(blank, 1e-3, 1e-3);
  State s;
  s.position = test::rolled(blank, 0.05, 0.3);
  s.force.assign(s.position.size(), {});
  BendingState b;
  start(bending, s.position, b);
  for (auto _ : run) {
    bending_forces(bending, b, s, 5e-6);
    benchmark::DoNotOptimize(s.force.data());
  }
  run.counters["ns_per_item"] = benchmark::Counter(
      static_cast<double>(run.iterations()) * static_cast<double>(blank.mesh.triangles.size()) * 1e-9,
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(bending, diagonal, Pattern::diagonal);
BENCHMARK_CAPTURE(bending, unstructured, Pattern::unstructured);

/// A full search of the nearest point on a sphere of 20,000 facets.
void nearest_point(benchmark::State& run)
{
  const ToolSurface sphere(test::sphere(0.075, 71));
  int i = 0;
  for (auto _ : run) {
    const double turn = 0.37 * ++i;
    benchmark::DoNotOptimize(sphere.nearest({0.076 * std::cos(turn), 0.076 * std::sin(turn), 0.01}));
  }
}
BENCHMARK(nearest_point);

} // namespace
} // namespace towform
