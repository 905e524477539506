#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>

namespace towform {

/// Sets how many threads the loops below use from now on; 0 for as many as OMP_NUM_THREADS says or, without
/// it, as the machine has. Not from inside a loop.
void set_threads(int count);
[[nodiscard]] int threads();

namespace parallel {
/// Calls task(context, part) for every part 0 .. threads()-1 at once and returns when all are done. Waiting
/// threads spin for some microseconds, as loops of a time step follow each other closely, and then sleep, so
/// that on a busy machine they leave their core to whoever they wait for.
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

/// body(index) for 0 .. count-1, each thread taking the next that is left: for work of uneven size.
template <class Body>
void parallel_each(int count, const Body& body)
{
  struct Context {
    int count;
    const Body& body;
    std::atomic<int> next;
  } context{count, body, 0};
  parallel::on_all_threads(
      [](void* shared, int) {
        auto& c = *static_cast<Context*>(shared);
        for (int i = c.next.fetch_add(1, std::memory_order_relaxed); i < c.count;
             i = c.next.fetch_add(1, std::memory_order_relaxed))
          c.body(i);
      },
      &context);
}

} // namespace towform
