#include "parallel/parallel.hpp"
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

namespace towform {

namespace {

inline void relax()
{
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until `value` differs from `old`: some microseconds of spinning, then asleep.
template <class T>
void wait_while(const std::atomic<T>& value, T old)
{
  constexpr int spins = 2000;
  for (int i = 0; i < spins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax();
  }
  while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

/// Whether this thread is in a loop's body: a loop in there is its own.
thread_local bool in_a_loop = false; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// The calling thread and its helpers.
class Team {
public:
  explicit Team(int count) : count_(count)
  {
    for (int part = 1; part < count; ++part) helpers_.emplace_back([this, part] { help(part); });
  }
  ~Team()
  {
    task_ = nullptr;
    begin();
    for (std::thread& helper : helpers_) helper.join();
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  [[nodiscard]] int count() const { return count_; }

  void run(void (*task)(void*, int), void* context)
  {
    const auto all_parts = [&] {
      for (int part = 0; part < count_; ++part) task(context, part);
    };
    if (count_ == 1 || in_a_loop) return all_parts();
    const Clock::time_point start = Clock::now();
    if (start < alone_until_) return all_parts();
    task_ = task;
    context_ = context;
    busy_.store(count_ - 1, std::memory_order_relaxed);
    begin();
    in_a_loop = true;
    task(context, 0);
    in_a_loop = false;
    const Clock::time_point done = Clock::now();
    for (int left = busy_.load(std::memory_order_acquire); left != 0;
         left = busy_.load(std::memory_order_acquire))
      wait_while(busy_, left);
    const Clock::time_point end = Clock::now();
    judge(end - done, end - start, end);
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr Clock::duration look = std::chrono::milliseconds(2); ///< at the share of waiting, this often
  static constexpr Clock::duration shortest_rest = std::chrono::milliseconds(100);
  static constexpr Clock::duration longest_rest = std::chrono::milliseconds(1000);

  /// Where another program has a helper's core, waiting for the helper takes longer than doing its part: the caller then
  /// goes on alone for a while, longer each time that it finds no better.
  void judge(Clock::duration waited, Clock::duration whole, Clock::time_point now)
  {
    waited_ += waited;
    whole_ += whole;
    if (whole_ < look) return;
    constexpr double too_much = 0.4;
    const bool waits =
        std::chrono::duration<double>(waited_).count() > too_much * std::chrono::duration<double>(whole_).count();
    rest_ = waits ? std::clamp(2 * rest_, shortest_rest, longest_rest) : Clock::duration::zero();
    alone_until_ = now + rest_;
    waited_ = whole_ = Clock::duration::zero();
  }

  void begin()
  {
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }

  void help(int part)
  {
    in_a_loop = true;
    for (std::uint32_t seen = 0;; ++seen) {
      wait_while(round_, seen);
      if (task_ == nullptr) return;
      task_(context_, part);
      if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
    }
  }

  Clock::duration waited_{}, whole_{}, rest_{}; // of the caller, in loops since it last looked
  Clock::time_point alone_until_{};
  int count_; // NOLINT(clang-analyzer-optin.performance.Padding): the counters keep their cache lines apart
  void (*task_)(void*, int) = nullptr;
  void* context_ = nullptr;
  alignas(64) std::atomic<std::uint32_t> round_{0};
  alignas(64) std::atomic<int> busy_{0};
  std::vector<std::thread> helpers_;
};

/// OMP_NUM_THREADS, where a queue or a user has set it, else the machine's cores.
int all_cores()
{
  if (const char* wanted =
          std::getenv("OMP_NUM_THREADS")) // NOLINT(concurrency-mt-unsafe): read once, at the start
    if (const int count = std::atoi(wanted); count > 0)
      return count; // NOLINT(bugprone-unchecked-string-to-number-conversion)
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::unique_ptr<Team>& team()
{
  static std::unique_ptr<Team> the_team = std::make_unique<Team>(all_cores());
  return the_team;
}

} // namespace

void set_threads(int count)
{
  const int wanted = count > 0 ? count : all_cores();
  if (wanted == team()->count()) return;
  team().reset();
  team() = std::make_unique<Team>(wanted);
}

int threads() { return team()->count(); }

void parallel::on_all_threads(void (*task)(void*, int), void* context) { team()->run(task, context); }

} // namespace towform
