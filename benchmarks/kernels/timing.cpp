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

std::vector<Timing> time_in_turns(const std::vector<Way>& ways, std::size_t states, int turns) {
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<double>> times(ways.size()), ratios(ways.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i].run(0, 1);
      const auto start = Clock::now();
      ways[i].run(0, states);
      const std::chrono::duration<double, std::nano> time = Clock::now() - start;
      times[i].push_back(time.count() / static_cast<double>(states));
      ratios[i].push_back(times[i].back() / times[0].back());
    }
  }
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < ways.size(); ++i) timings.push_back({spread_of(times[i]), spread_of(ratios[i])});
  return timings;
}

}  // namespace kernels
