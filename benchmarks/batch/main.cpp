// SPDX-License-Identifier: GPL-3.0-or-later
// batch [FILE.csv]: nanoseconds for one state of a seven-joint arm, by the single kernels and by packs as wide as this
// processor's registers, on one thread. All ways take turns in one run; the median of the turns is printed, how many
// times faster than the single kernel in double it is, and the spread (a quarter of the turns below, a quarter above).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/batch/measured.hpp"

namespace {

constexpr int turns = 301;

double nanoseconds(const Way& way) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  way.run();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / double{table_size};
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* csv = argc > 1 ? std::fopen(argv[1], "w") : nullptr;
  if (argc > 1 && csv == nullptr) {
    fmt::print(stderr, "batch: cannot write {}\n", argv[1]);
    return 3;
  }
  const auto all = ways();
  std::vector<std::vector<double>> times(all.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < all.size(); ++i) times[i].push_back(nanoseconds(all[i]));
  }
  if (csv != nullptr) fmt::print(csv, "kernel,scalar,lanes,ns,ratio,ns_lower_quartile,ns_upper_quartile,difference\n");
  fmt::print("{:<18}{:<8}{:>6}{:>9}{:>8}   {:<18}{}\n", "kernel", "scalar", "lanes", "ns", "ratio", "quartiles",
             "difference");
  double single = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    const double low = times[i][turns / 4], median = times[i][turns / 2], high = times[i][3 * turns / 4];
    if (all[i].lanes == 1 && std::strcmp(all[i].scalar, "double") == 0) single = median;
    const double difference = worst_difference(all[i].kernel, all[i].scalar);
    fmt::print("{:<18}{:<8}{:>6}{:>9.1f}{:>8.2f}   {:<18}{:.0e}\n", all[i].kernel, all[i].scalar, all[i].lanes, median,
               single / median, fmt::format("{:.1f} to {:.1f}", low, high), difference);
    if (csv != nullptr) {
      fmt::print(csv, "{},{},{},{:.3f},{:.4f},{:.3f},{:.3f},{:.1e}\n", all[i].kernel, all[i].scalar, all[i].lanes,
                 median, single / median, low, high, difference);
    }
  }
  if (csv != nullptr && std::fclose(csv) != 0) {
    fmt::print(stderr, "batch: cannot write {}: is the disk full?\n", argv[1]);
    return 3;
  }
  return 0;
}
