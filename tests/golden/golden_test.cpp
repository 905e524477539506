#include "golden_cases.hpp"
#include <gtest/gtest.h>

namespace towform {
namespace {

RunOptions options(const std::filesystem::path& where, int threads, std::int64_t max_steps = 0)
{
  RunOptions o{where, threads, true};
  o.controls.max_steps = max_steps;
  return o;
}

TEST_F(Golden, StatesAreTheSameOnAnyNumberOfThreadsAndAfterResuming)
{
  for (const Short& each : cases()) {
    SCOPED_TRACE(each.name);
    const Case c = read(each);
    const std::filesystem::path whole = directory / each.name / "whole";
    const RunOutcome done = run(c, options(whole, 1));
    ASSERT_EQ(done.code, ExitCode::done) << done.summary.message;
    const std::int64_t steps = done.summary.steps;
    ASSERT_GT(steps, 10);

    std::string hash;
    for (const int threads : {1, 2, 3, 4, 7}) {
      const std::filesystem::path here = directory / each.name / std::to_string(threads);
      EXPECT_EQ(run(c, options(here, threads, steps)).code, ExitCode::interrupted);
      if (hash.empty()) hash = state_hash(here);
      EXPECT_EQ(state_hash(here), hash) << threads << " threads";
    }

    // Stopped again and again, going on with another number of threads each time.
    const std::filesystem::path pieces = directory / each.name / "pieces";
    const std::int64_t piece = steps / 7 + 1;
    ASSERT_EQ(run(c, options(pieces, 2, piece)).code, ExitCode::interrupted);
    std::int64_t at = piece;
    for (int threads = 3; at < steps; threads = threads % 3 + 1, at += piece)
      ASSERT_EQ(resume(options(pieces, threads, std::min(piece, steps - at))).code, ExitCode::interrupted);
    EXPECT_EQ(state_hash(pieces), hash);
    const RunOutcome end = resume(options(pieces, 1));
    EXPECT_EQ(end.code, ExitCode::done) << end.summary.message;
    EXPECT_EQ(text_of(pieces / "history.csv"), text_of(whole / "history.csv"));
    EXPECT_EQ(text_of(pieces / "results.xdmf"), text_of(whole / "results.xdmf"));
    EXPECT_EQ(frames_of(pieces), frames_of(whole));
    EXPECT_EQ(end.summary.punch_force_max_N, done.summary.punch_force_max_N);
    EXPECT_EQ(end.summary.kinetic_to_internal_max, done.summary.kinetic_to_internal_max);
    EXPECT_EQ(end.summary.penetration_max_mm, done.summary.penetration_max_mm);
    EXPECT_EQ(end.summary.step_min_s, done.summary.step_min_s);
    EXPECT_EQ(end.summary.energies_J, done.summary.energies_J);
    EXPECT_FALSE(std::filesystem::exists(checkpoint_path(pieces)));
  }
}

TEST_F(Golden, WhatWasWrittenAfterTheCheckpointIsCutBack)
{
  const Short press = cases().front();
  const Case c = read(press);
  const std::filesystem::path whole = directory / "whole", cut = directory / "cut";
  const RunOutcome done = run(c, options(whole, 1));
  const std::int64_t early = done.summary.steps / 5, late = done.summary.steps - early;
  ASSERT_EQ(run(c, options(cut, 1, early)).code, ExitCode::interrupted);
  std::filesystem::copy(checkpoint_path(cut), directory / "early.h5");
  ASSERT_EQ(resume(options(cut, 1, late - early)).code, ExitCode::interrupted);
  const auto frames_before = frames_of(cut).size();
  std::filesystem::rename(directory / "early.h5", checkpoint_path(cut)); // as if it had died before the next
  ASSERT_EQ(resume(options(cut, 1, 1)).code, ExitCode::interrupted);
  EXPECT_LT(frames_of(cut).size(), frames_before);
  ASSERT_EQ(resume(options(cut, 1)).code, ExitCode::done);
  EXPECT_EQ(text_of(cut / "history.csv"), text_of(whole / "history.csv"));
  EXPECT_EQ(frames_of(cut), frames_of(whole));
}

} // namespace
} // namespace towform
