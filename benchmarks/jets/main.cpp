// SPDX-License-Identifier: GPL-3.0-or-later
// jets [FILE.csv]: nanoseconds for the Taylor coefficients of a motion to some orders, by the kernel `jets` of
// generated headers, beside one evaluation of `forward_dynamics`; for one trajectory, and for each of four in the lanes
// of a pack. All take turns in one run; the median of the turns is printed.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "generated/double_pendulum.hpp"
#include "generated/heavy_top.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/torque_free_body.hpp"
#include "torsor/runtime/batch/simd.hpp"

namespace {

using Clock = std::chrono::steady_clock;
constexpr int turns = 501;  // of some microseconds: few are interrupted by other programs
constexpr int states = 32;
constexpr std::array orders{12, 15, 20, 30};

struct Way {
  std::string name;
  int lanes;
  std::function<double(int)> run;  ///< on the state of that number; what it gives depends on all it has computed
};

/// The motion's start and others beside it.
template <class Mechanism>
auto state_beside(int number) {
  using Scalar = decltype(Mechanism::initial_state().time);
  auto state = Mechanism::initial_state();
  for (int i = 0; i < Mechanism::velocity_count; ++i) {
    state.q[i] = state.q[i] + Scalar(0.003) * Scalar(static_cast<double>((number * 5 + i) % states));
    state.v[i] = state.v[i] + Scalar(0.01) * Scalar(static_cast<double>((number * 7 + i * 3) % states));
  }
  return state;
}

double first(double x) { return x; }
template <class Pack>
double first(const Pack& x) {
  return x[0];
}

template <class Mechanism>
Way forward_dynamics() {
  const auto precomputed = Mechanism::precompute(Mechanism::default_parameters());
  return {"forward_dynamics", 1, [precomputed](int number) {
            typename Mechanism::Accelerations a{};
            typename Mechanism::Multipliers lambda{};
            Mechanism::forward_dynamics(precomputed, state_beside<Mechanism>(number), {}, a, lambda);
            double sum = 0;
            for (int i = 0; i < Mechanism::velocity_count; ++i) sum += a[i];
            return sum;
          }};
}

template <class Mechanism>
Way jets(int order, int lanes) {
  constexpr std::size_t size = Mechanism::coordinate_count + Mechanism::velocity_count;
  using Scalar = decltype(Mechanism::initial_state().time);
  const auto precomputed = Mechanism::precompute(Mechanism::default_parameters());
  return {fmt::format("jets, order {}{}", order, lanes > 1 ? ", in lanes" : ""), lanes, [=](int number) {
            std::array<std::array<Scalar, size>, 31> c;
            Mechanism::jets(precomputed, state_beside<Mechanism>(number), {}, order, c.data());
            return first(c[static_cast<std::size_t>(order)][size - 1]);
          }};
}

template <template <class> class Mechanism>
void measure(std::FILE* csv) {
  constexpr int lanes = 4;
  using Pack = torsor::runtime::Simd<double, lanes>;
  std::vector<Way> ways{forward_dynamics<Mechanism<double>>()};
  for (const int order : orders) ways.push_back(jets<Mechanism<double>>(order, 1));
  for (const int order : orders) ways.push_back(jets<Mechanism<Pack>>(order, lanes));
  std::vector<std::vector<double>> times(ways.size());
  double sum = 0;
  for (int turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const auto start = Clock::now();
      for (int state = 0; state < states; ++state) sum += ways[i].run(state);
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      times[i].push_back(1e9 * seconds / states / ways[i].lanes);
    }
  }
  const char* const name = Mechanism<double>::name;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    std::sort(times[i].begin(), times[i].end());
    const double median = times[i][turns / 2], ratio = median / times[0][turns / 2];
    fmt::print("{:<18}{:<26}{:>9.0f}{:>9.1f}\n", name, ways[i].name, median, ratio);
    if (csv != nullptr) fmt::print(csv, "{},\"{}\",{:.1f},{:.2f}\n", name, ways[i].name, median, ratio);
  }
  if (sum != sum) fmt::print(stderr, "{}: a result is not a number\n", name);
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* csv = argc > 1 ? std::fopen(argv[1], "w") : nullptr;
  if (argc > 1 && csv == nullptr) {
    fmt::print(stderr, "jets: cannot write {}\n", argv[1]);
    return 3;
  }
  if (csv != nullptr) fmt::print(csv, "mechanism,kernel,ns_per_state,ratio_to_forward_dynamics\n");
  fmt::print("{:<18}{:<26}{:>9}{:>9}\n", "mechanism", "kernel", "ns/state", "ratio");
  measure<double_pendulum::Mechanism>(csv);
  measure<heavy_top::Mechanism>(csv);
  measure<torque_free_body::Mechanism>(csv);
  measure<rolling_hoop::Mechanism>(csv);
  if (csv != nullptr && std::fclose(csv) != 0) {
    fmt::print(stderr, "jets: cannot write {}: is the disk full?\n", argv[1]);
    return 3;
  }
  return 0;
}
