#pragma once
#include "output/output_directory.hpp"
#include "towform/error.hpp"
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <thread>

namespace towform {

/// read() of results that a run may be writing. No lock keeps a reader out, so that none can stop a run: it
/// may meet half a write, or come before the first frame. While a run has the directory, reading is tried
/// again until it works, for up to `patience` seconds. Throws FileError: what read() threw, when nobody
/// writes.
template <class Read>
auto read_while_written(const std::filesystem::path& directory, double patience, const Read& read)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds longest_pause{200};
  std::chrono::milliseconds pause{10};
  const auto end = Clock::now() + std::chrono::duration<double>(patience);
  while (true) {
    const bool was_in_use = is_in_use(directory); // a run that ends while it is read leaves whole results
    try {
      return read();
    } catch (const FileError& e) {
      if (!was_in_use && !is_in_use(directory)) throw;
      if (Clock::now() >= end)
        throw FileError(
            fmt::format("{}\n{}: a run is still writing there; try again when it has come further", e.what(),
                        directory.empty() ? "." : directory.string()));
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, longest_pause);
  }
}

} // namespace towform
