// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds of a call before and now, in turns.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <random>
#include <vector>

#include "calls.hpp"

namespace {

double nanoseconds(const Kernels& kernel) {
  const auto start = std::chrono::steady_clock::now();
  for (int sample = 0; sample < sample_count; ++sample) kernel.call(sample);
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count() / sample_count;
}

}  // namespace

int main() {
  if (joints_before != joints_now) {
    std::fprintf(stderr, "the robots have %d and %d joints: compare one with itself\n", static_cast<int>(joints_before),
                 static_cast<int>(joints_now));
    return 1;
  }
  std::mt19937 generator(1);
  std::vector<double> numbers(static_cast<std::size_t>(3 * joints_now * sample_count));
  for (double& number : numbers) number = 2 * (static_cast<double>(generator()) / 4294967296.0) - 1;
  prepare_before(numbers.data());
  prepare_now(numbers.data());
  for (int k = 0; k < kernel_count; ++k) {
    double before = 1e9, now = 1e9;
    for (int turn = 0; turn < 3000; ++turn) {
      before = std::min(before, nanoseconds(kernels_before[k]));
      now = std::min(now, nanoseconds(kernels_now[k]));
    }
    std::printf("%s %.2f %.2f\n", kernels_now[k].name, before, now);
  }
  return 0;
}
