// Kernels of a step on one thread: build/release/tests/bench/towform_bench (target towform_bench).
#include "bench/machine.hpp"
#include "contact/contact.hpp"
#include "contact/shapes.hpp"
#include "element/bent.hpp"
#include "element/sheet.hpp"
#include "parallel/parallel.hpp"
#include <benchmark/benchmark.h>

namespace towform {
namespace {

/// ns per element or node in the column ns_per_item.
void per_item(benchmark::State& run, std::size_t items)
{
  run.counters["ns_per_item"] =
      benchmark::Counter(static_cast<double>(run.iterations()) * static_cast<double>(items) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Forces of a sheet that shears at about 10 rad/s; ns per element.
void membrane(benchmark::State& run, LawKind kind, YarnStrain yarn_strain)
{
  set_threads(1);
  const Blank blank = test::blank(Pattern::diagonal, 0.0, 0.0, static_cast<int>(run.range(0)));
  const Membrane membrane(blank, YarnLaw{1e6, 0.1}, test::law(kind), yarn_strain);
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
  per_item(run, membrane.triangles.size());
}
BENCHMARK_CAPTURE(membrane, viscous, LawKind::viscous, YarnStrain::triangle)->Arg(20000);
BENCHMARK_CAPTURE(membrane, viscous_strips, LawKind::viscous, YarnStrain::strip)->Arg(20000);
BENCHMARK_CAPTURE(membrane, incremental, LawKind::incremental, YarnStrain::triangle)->Arg(20000);
BENCHMARK_CAPTURE(membrane, incremental_strips, LawKind::incremental, YarnStrain::strip)->Arg(20000);
BENCHMARK_CAPTURE(membrane, elastic, LawKind::elastic, YarnStrain::triangle)->Arg(20000);
BENCHMARK_CAPTURE(membrane, elastic_strips, LawKind::elastic, YarnStrain::strip)->Arg(20000);

/// Bending forces of a sheet on a cylinder; ns per element.
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
  per_item(run, blank.mesh.triangles.size());
}
BENCHMARK_CAPTURE(bending, diagonal, Pattern::diagonal);
BENCHMARK_CAPTURE(bending, unstructured, Pattern::unstructured);

/// Nodes' forces from those of the blocks; ns per element.
void assembly(benchmark::State& run)
{
  set_threads(1);
  const Blank blank = test::blank(Pattern::diagonal, 0.0, 0.0, 20000);
  const Membrane membrane(blank, YarnLaw{1e6, 0.1}, test::law(LawKind::viscous), YarnStrain::strip);
  State s = test::at_rest(membrane, blank.mesh.points);
  for (auto _ : run) {
    assemble(membrane.blocks, s.block_force, s.force);
    benchmark::DoNotOptimize(s.force.data());
  }
  per_item(run, membrane.triangles.size());
}
BENCHMARK(assembly);

/// A sheet pressed on a sphere and sliding over it at 0.5 m/s; ns per node.
void contact(benchmark::State& run)
{
  set_threads(1);
  constexpr double dt = 5e-6, radius = 0.075, half = 0.5e-3;
  const Tool ball{"ball", ToolSurface(test::sphere(radius, 71)), 0.3, {}, {}, {0, 0, 1}, 0.0};
  const Contact pressed(ball, 0, half, 0.1, 0.3, 1.0, dt);
  const Blank blank = test::blank(Pattern::diagonal, 0.0, 0.0, 20000);
  const std::size_t nodes = blank.mesh.points.size();
  State s;
  s.position.resize(nodes);
  s.velocity.assign(nodes, {0.5, 0.0, 0.0});
  s.force.assign(nodes, {});
  const std::vector<double> area(nodes, 1e-5);
  ToolState tool_state;
  ContactState state;
  start(pressed, nodes, state);
  double turn = 0.0;
  const auto slide = [&] {
    turn += 0.5 * dt / radius;
    for (std::size_t n = 0; n < nodes; ++n) {
      const double along = blank.mesh.points[n].x / radius + turn, across = blank.mesh.points[n].y / radius;
      const double r = radius + half - 2e-6;
      s.position[n] = {r * std::sin(along) * std::cos(across), r * std::sin(across),
                       r * std::cos(along) * std::cos(across)};
    }
  };
  const auto meet = [&] {
    contact_forces({&pressed, 1}, {&ball, 1}, {&tool_state, 1}, {&state, 1}, area, {}, s, dt, 0.51 * dt);
    benchmark::DoNotOptimize(s.force.data());
  };
  slide();
  meet(); // finds all nodes for the first time
  for (auto _ : run) {
    run.PauseTiming();
    slide();
    run.ResumeTiming();
    meet();
  }
  per_item(run, nodes);
}
BENCHMARK(contact);

/// What the machine can do at most: streams from memory (a = b + c x d on arrays far larger than caches), bytes
/// read and written.
void memory_triad(benchmark::State& run)
{
  constexpr std::size_t size = 1 << 24;
  std::vector<double> a(size, 0.0), b(size, 1.0), c(size, 2.0);
  for (auto _ : run) {
    triad(a.data(), b.data(), c.data(), 3.0, size);
    benchmark::DoNotOptimize(a.data());
  }
  run.SetBytesProcessed(static_cast<std::int64_t>(run.iterations() * 3 * size * sizeof(double)));
}
BENCHMARK(memory_triad);

/// Multiplications and additions from registers, not fused, as the solver's.
void arithmetic(benchmark::State& run)
{
  double sum = 0.0;
  for (auto _ : run) benchmark::DoNotOptimize(sum += multiply_and_add(1000));
  run.counters["flops"] = benchmark::Counter(static_cast<double>(run.iterations()) * 1000.0 * flops_a_round,
                                             benchmark::Counter::kIsRate);
}
BENCHMARK(arithmetic);

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
