#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace towform {

/// Sets how many threads the loops below use from now on; 0 for as many as OMP_NUM_THREADS says or, without
/// it, as the machine has. Not from inside a loop.
void set_threads(int count);
[[nodiscard]] int threads();

namespace parallel {
/// Calls task(context, part) for every part 0 .. threads()-1 at once and returns when all are done. Waiting
/// threads spin for some microseconds, as loops of a time step follow each other closely, and then sleep, so
/// that on a busy machine they leave their core to whoever they wait for. Where that waiting takes too long, the
/// calling thread does all parts itself for some time. Within a task all parts of another one are done where it is called.
void on_all_threads(void (*task)(void* context, int part), void* context);
} // namespace parallel

/// body(begin, end) on consecutive, equal ranges of 0 .. count-1, one a thread. What an index computes must
/// not depend on the range it is in: results are the same for any number of threads.
template <class Body>
void parallel_ranges(std::ptrdiff_t count, const Body& body)
{
  struct Context {
    std::ptrdiff_t count;
    const Body& body;
  } context{count, body};
  parallel::on_all_threads(
      [](void* shared, int part) {
        const auto& [n, work] = *static_cast<Context*>(shared);
        const int parts = threads();
        work(n * part / parts, n * (part + 1) / parts);
      },
      &context);
}

namespace parallel {
/// Numbers 0 .. count-1 dealt out to parts: each has a range of its own, the same in every loop, so that its data
/// stay in its cache, and helps others once that is done.
class Shares {
public:
  Shares(int count, int parts) : count_(count), next_(static_cast<std::size_t>(parts)) {}

  /// The next number for a part, or -1.
  int take(int part)
  {
    const int parts = static_cast<int>(next_.size());
    for (int i = 0; i < parts; ++i) {
      const int from = (part + i) % parts;
      const int first = begin(from), end = begin(from + 1);
      std::atomic<int>& next = next_[static_cast<std::size_t>(from)].taken;
      if (first + next.load(std::memory_order_relaxed) >= end) continue;
      if (const int number = first + next.fetch_add(1, std::memory_order_relaxed); number < end) return number;
    }
    return -1;
  }

private:
  struct alignas(64) Counter {
    std::atomic<int> taken{0};
  };
  [[nodiscard]] int begin(int part) const
  {
    return static_cast<int>(static_cast<std::ptrdiff_t>(count_) * part / static_cast<std::ptrdiff_t>(next_.size()));
  }
  int count_;
  std::vector<Counter> next_;
};
} // namespace parallel

/// body(index) for 0 .. count-1, shared out as they are done: for work of uneven size.
template <class Body>
void parallel_each(int count, const Body& body)
{
  struct Context {
    const Body& body;
    parallel::Shares shares;
  } context{body, {count, threads()}};
  parallel::on_all_threads(
      [](void* shared, int part) {
        auto& c = *static_cast<Context*>(shared);
        for (int i = c.shares.take(part); i >= 0; i = c.shares.take(part)) c.body(i);
      },
      &context);
}

/// Sum of body(begin, end) over blocks of 0 .. count-1, added in their order: the same for any number of threads.
template <class Body>
double parallel_sum(std::size_t count, const Body& body)
{
  constexpr std::size_t block = 1024;
  std::vector<double> sums((count + block - 1) / block);
  parallel_each(static_cast<int>(sums.size()), [&](int number) {
    const std::size_t begin = block * static_cast<std::size_t>(number);
    sums[static_cast<std::size_t>(number)] = body(begin, std::min(count, begin + block));
  });
  double sum = 0.0;
  for (const double s : sums) sum += s;
  return sum;
}

} // namespace towform
