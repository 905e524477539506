#include "parallel/parallel.hpp"
#include <array>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace towform {
namespace {

class Parallel : public testing::TestWithParam<int> {
protected:
  void SetUp() override { set_threads(GetParam()); }
  void TearDown() override { set_threads(0); }
};

TEST_P(Parallel, RangesCoverEveryIndexOnce)
{
  EXPECT_EQ(threads(), GetParam());
  for (const int count : {0, 1, 2, 5, 1000}) {
    std::vector<int> visits(static_cast<std::size_t>(count), 0);
    parallel_ranges(count, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
      for (std::ptrdiff_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), count);
  }
}

TEST_P(Parallel, EachIndexIsTakenOnce)
{
  std::vector<int> visits(777, 0);
  for (int round = 0; round < 200; ++round) parallel_each(777, [&](int i) { ++visits[i]; });
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 200), 777);
}

TEST_P(Parallel, ManyShortLoopsSeeEachOthersResults)
{
  std::vector<long> value(64, 1);
  for (int round = 0; round < 5000; ++round)
    parallel_ranges(64, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
      for (std::ptrdiff_t i = begin; i < end; ++i) value[i] += 1;
    });
  EXPECT_EQ(std::accumulate(value.begin(), value.end(), 0L), 64L * 5001);
}

TEST_P(Parallel, LoopsWithinLoopsDoAll)
{
  constexpr int outer = 50, inner = 40;
  std::array<std::array<int, inner>, outer> taken{};
  parallel_each(outer, [&](int i) {
    parallel_ranges(inner, [&](auto begin, auto end) {
      for (auto j = begin; j < end; ++j) ++taken[i][j];
    });
  });
  for (const auto& row : taken)
    for (const int times : row) EXPECT_EQ(times, 1);
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, testing::Values(1, 2, 3, 7));

} // namespace
} // namespace towform
