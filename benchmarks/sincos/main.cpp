// SPDX-License-Identifier: GPL-3.0-or-later
// sincos [FILE.csv]: nanoseconds for the sine and cosine of one angle, by the standard library and by generated
// headers, one angle at a time and several. All ways take turns in one run; the median of the turns is printed, the
// ratio to the standard library's beside it, and the spread (a quarter of the turns is below, a quarter above).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/sincos/measured.hpp"

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t table_size = 1024;
constexpr int turns = 1001;  // of some microseconds: few are interrupted by other programs

template <class Scalar>
double nanoseconds(const Way<Scalar>& way, const std::vector<Scalar>& angles, std::vector<Scalar>& sines,
                   std::vector<Scalar>& cosines) {
  const auto start = Clock::now();
  way.run(angles.data(), sines.data(), cosines.data(), table_size);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / double{table_size};
}

template <class Scalar>
void measure(const char* build, const char* type, Ways<Scalar> ways, std::FILE* csv) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Scalar> angle(Scalar(-3.2), Scalar(3.2));
  std::vector<Scalar> angles(table_size), sines(table_size), cosines(table_size);
  for (Scalar& each : angles) each = angle(random);
  std::vector<std::vector<double>> times(ways.size());
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t way = 0; way < ways.size(); ++way)
      times[way].push_back(nanoseconds(ways[way], angles, sines, cosines));
  }
  for (std::vector<double>& each : times) std::sort(each.begin(), each.end());
  const double library = times[0][turns / 2];
  for (std::size_t way = 0; way < ways.size(); ++way) {
    const double median = times[way][turns / 2], low = times[way][turns / 4], high = times[way][3 * turns / 4];
    fmt::print("{:<10}{:<8}{:<20}{:>8.2f}{:>8.3f}   {:.2f} to {:.2f}\n", build, type, ways[way].name, median,
               median / library, low, high);
    if (csv != nullptr) {
      fmt::print(csv, "{},{},\"{}\",{},{:.3f},{:.4f},{:.3f},{:.3f}\n", build, type, ways[way].name, ways[way].angles,
                 median, median / library, low, high);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* csv = argc > 1 ? std::fopen(argv[1], "w") : nullptr;
  if (argc > 1 && csv == nullptr) {
    fmt::print(stderr, "sincos: cannot write {}\n", argv[1]);
    return 3;
  }
  if (csv != nullptr) fmt::print(csv, "build,scalar,way,angles,ns,ratio,ns_lower_quartile,ns_upper_quartile\n");
  fmt::print("{:<10}{:<8}{:<20}{:>8}{:>8}   {}\n", "build", "scalar", "way, angles", "ns", "ratio", "quartiles");
  measure("generic", "double", generic_build::ways_in_double(), csv);
  measure("generic", "float", generic_build::ways_in_float(), csv);
  measure("native", "double", native_build::ways_in_double(), csv);
  measure("native", "float", native_build::ways_in_float(), csv);
  if (csv != nullptr && std::fclose(csv) != 0) {
    fmt::print(stderr, "sincos: cannot write {}: is the disk full?\n", argv[1]);
    return 3;
  }
  return 0;
}
