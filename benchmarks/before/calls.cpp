// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of one header, which is included before this file: ROBOT is its namespace, WHEN ends the names that are exported.
#include <array>
#include <cstddef>

#include "calls.hpp"

#define JOINED(a, b) a##_##b
#define NAMED(a, b) JOINED(a, b)

namespace {

using Mechanism = ROBOT::Mechanism<double>;

struct Call {
  Mechanism::State state{};
  Mechanism::Accelerations accelerations{};
  Mechanism::Inputs inputs{};
};

std::array<Call, sample_count> samples;

const Mechanism::Precomputed precomputed = Mechanism::precompute({});

template <class Result, class Kernel>
void run(int sample, const Kernel& kernel) {
  static Result result;
  kernel(samples[static_cast<std::size_t>(sample)], result);
  asm volatile("" : : "r"(&result) : "memory");  // the result is wanted
}

void mass_matrix(int sample) {
  constexpr std::size_t n = Mechanism::velocity_count;
  run<std::array<double, n * n>>(sample, [](const Call& call, auto& result) {
    Mechanism::mass_matrix(precomputed, call.state, result);
  });
}

void inverse_dynamics(int sample) {
  run<Mechanism::GeneralizedForces>(sample, [](const Call& call, auto& result) {
    Mechanism::inverse_dynamics(precomputed, call.state, call.accelerations, result);
  });
}

void forward_dynamics(int sample) {
  run<Mechanism::Accelerations>(sample, [](const Call& call, auto& result) {
    static_cast<void>(Mechanism::forward_dynamics(precomputed, call.state, call.inputs, result));
  });
}

void inverse_dynamics_derivatives(int sample) {
  run<Mechanism::InverseDynamicsDerivatives>(sample, [](const Call& call, auto& result) {
    Mechanism::inverse_dynamics_derivatives(precomputed, call.state, call.accelerations, result);
  });
}

void forward_dynamics_derivatives(int sample) {
  run<Mechanism::ForwardDynamicsDerivatives>(sample, [](const Call& call, auto& result) {
    static_cast<void>(Mechanism::forward_dynamics_derivatives(precomputed, call.state, call.inputs, result));
  });
}

}  // namespace

const Kernels NAMED(kernels, WHEN)[kernel_count] = {{"mass_matrix", mass_matrix},
                                                    {"inverse_dynamics", inverse_dynamics},
                                                    {"forward_dynamics", forward_dynamics},
                                                    {"inverse_dynamics_derivatives", inverse_dynamics_derivatives},
                                                    {"forward_dynamics_derivatives", forward_dynamics_derivatives}};
const int NAMED(joints, WHEN) = Mechanism::velocity_count;

void NAMED(prepare, WHEN)(const double* numbers) {
  for (Call& call : samples) {
    for (int i = 0; i < Mechanism::velocity_count; ++i) {
      call.state.q[i] = *numbers++;
      call.state.v[i] = *numbers++;
      call.accelerations[i] = *numbers++;
    }
  }
}
