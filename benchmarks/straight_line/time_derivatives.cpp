// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds of forward_dynamics_derivatives of one generated header: HEADER its path, MODEL its namespace.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <random>
#include <vector>

#include HEADER

using Mechanism = MODEL::Mechanism<double>;

namespace {

struct Sample {
  Mechanism::State state;
  Mechanism::Inputs inputs;
};

}  // namespace

int main() {
  constexpr std::size_t samples = 64, turns = 201;
  constexpr int joints = Mechanism::velocity_count;
  std::mt19937 generator(1);
  const auto uniform = [&generator] { return 2 * (generator() / 4294967296.0) - 1; };
  std::vector<Sample> all(samples);
  for (Sample& sample : all) {
    for (int i = 0; i < joints; ++i) {
      sample.state.q[i] = 3 * uniform();
      sample.state.v[i] = uniform();
      sample.inputs[i] = uniform();
    }
  }
  const Mechanism::Precomputed precomputed = Mechanism::precompute({});
  static Mechanism::ForwardDynamicsDerivatives result;
  std::vector<double> times;
  for (std::size_t turn = 0; turn < turns; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    for (const Sample& sample : all) {
      const auto status = Mechanism::forward_dynamics_derivatives(precomputed, sample.state, sample.inputs, result);
      if (status != torsor::Status::ok) return 1;
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    times.push_back(taken.count() / samples);
  }
  std::sort(times.begin(), times.end());
  std::printf("%.0f,%.0f,%.0f\n", times.front(), times[turns / 4], times[turns / 2]);
  return 0;
}
