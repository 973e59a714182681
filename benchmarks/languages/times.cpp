// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds of a call in C++ and in C, in turns.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

#include "robot.hpp"

extern "C" void in_c(const double* state, const double* accelerations, double* forces);

namespace {

using Mechanism = robot::Mechanism<double>;
constexpr int joints = Mechanism::velocity_count;

struct Sample {
  Mechanism::State state;
  Mechanism::Accelerations accelerations;
  Mechanism::GeneralizedForces forces;
};

[[gnu::noinline]] void in_cpp(const Mechanism::Precomputed& precomputed, Sample& sample) {
  Mechanism::inverse_dynamics(precomputed, sample.state, sample.accelerations, sample.forces);
}

template <class Call>
double nanoseconds(std::vector<Sample>& samples, const Call& call) {
  const auto start = std::chrono::steady_clock::now();
  for (Sample& sample : samples) call(sample);
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count() / static_cast<double>(samples.size());
}

}  // namespace

int main() {
  std::mt19937 generator(1);
  const auto uniform = [&generator] { return 2 * (generator() / 4294967296.0) - 1; };
  std::vector<Sample> samples(64);
  for (Sample& sample : samples) {
    for (int i = 0; i < joints; ++i) {
      sample.state.q[i] = 3 * uniform();
      sample.state.v[i] = uniform();
      sample.accelerations[i] = uniform();
    }
  }
  const Mechanism::Precomputed precomputed = Mechanism::precompute({});
  double cpp = 1e9, c = 1e9;
  for (int turn = 0; turn < 2000; ++turn) {
    cpp = std::min(cpp, nanoseconds(samples, [&](Sample& sample) { in_cpp(precomputed, sample); }));
    c = std::min(c, nanoseconds(samples, [](Sample& sample) {
                   in_c(&sample.state.time, &sample.accelerations[0], &sample.forces[0]);
                 }));
  }
  std::printf("C++ %.2f\nC %.2f\n", cpp, c);
  return 0;
}
