// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace torsor::runtime {

/// What is asked for, or for 0 as many as the processor runs at once.
[[nodiscard]] inline unsigned thread_count(unsigned asked) noexcept {
  return asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
}

/// Calls work(part, first, end) for `parts` consecutive ranges that make up 0, ..., count - 1, each on a thread of its
/// own, and returns when all are done; the first part runs on the caller's. With OpenMP, where the caller is compiled
/// for it, the threads are those of its pool, else they are started and joined here: some ten microseconds a thread.
/// The work must not throw. A thread that cannot be started has its part done by the caller.
template <class Work>
void in_parts(std::size_t count, unsigned parts, const Work& work) {
  const std::size_t size = std::max<std::size_t>(1, std::min<std::size_t>(parts, count));
  const auto run = [&](std::size_t part) { work(part, count * part / size, count * (part + 1) / size); };
  if (size == 1) return run(0);
#if defined(_OPENMP)
#pragma omp parallel for num_threads(static_cast <int>(size)) schedule(static, 1)
  for (std::size_t part = 0; part < size; ++part) run(part);
#else
  std::vector<std::jthread> threads;
  threads.reserve(size - 1);
  std::size_t started = 1;
  try {
    for (; started < size; ++started) threads.emplace_back([&run, started] { run(started); });
  } catch (const std::system_error&) {
    for (std::size_t part = started; part < size; ++part) run(part);
  }
  run(0);
#endif
}

}  // namespace torsor::runtime
