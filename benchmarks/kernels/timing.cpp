// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/kernels/timing.hpp"

#include <algorithm>
#include <chrono>

namespace kernels {

Spread spread_of(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t n = numbers.size();
  return {numbers[n / 2], numbers[n / 4], numbers[3 * n / 4]};
}

namespace {

/// Nanoseconds for each of some states.
double time(const Way& way, std::size_t first, std::size_t count) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  way.run(first, first + count);
  const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
  return taken.count() / static_cast<double>(count);
}

/// How many states make a share: the quickest of some tries counts.
std::size_t share(const Way& way, std::size_t states) {
  double quickest = time(way, 0, 1);
  for (int again = 0; again < 5; ++again) quickest = std::min(quickest, time(way, 0, 1));
  return std::clamp(static_cast<std::size_t>(2e5 / quickest), std::size_t{1}, states);
}

}  // namespace

std::vector<Timing> time_in_turns(const std::vector<Way>& ways, std::size_t states, int turns) {
  std::vector<std::size_t> shares;
  for (const Way& way : ways) shares.push_back(share(way, states));
  std::vector<std::vector<double>> times(ways.size()), ratios(ways.size());
  for (std::size_t turn = 0; turn < static_cast<std::size_t>(turns); ++turn) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const std::size_t first = turn * shares[i] % (states - shares[i] + 1);
      ways[i].run(first, first + 1);
      times[i].push_back(time(ways[i], first, shares[i]));
      ratios[i].push_back(times[i].back() / times[0].back());
    }
  }
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < ways.size(); ++i) timings.push_back({spread_of(times[i]), spread_of(ratios[i])});
  return timings;
}

}  // namespace kernels
