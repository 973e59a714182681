// SPDX-License-Identifier: GPL-3.0-or-later
// The arm ur5 under a computed-torque controller, whose closed loop has a motion in closed form.
#include "work_precision_ur5.hpp"

#include <array>
#include <cmath>

#include "benchmarks/work_precision/ways.hpp"

namespace work_precision {
namespace {

using Mechanism = work_precision_ur5::Mechanism<double>;
constexpr int joints = Mechanism::velocity_count;
constexpr double rate = 4;  ///< 1/s, twice, of the errors

/// Joint i is to follow A_i sin(w_i t).
struct Wanted {
  double amplitude, frequency;
};
constexpr std::array<Wanted, joints> wanted{{{0.8, 1.1}, {0.6, 1.3}, {0.7, 1.7}, {0.9, 1.9}, {0.5, 2.3}, {1.0, 2.9}}};
constexpr std::array<double, joints> first_error{0.3, -0.2, 0.25, -0.3, 0.4, -0.1};

/// u = inverse dynamics at q_d'' - 2 k (q' - q_d') - k^2 (q - q_d): the errors follow e'' + 2 k e' + k^2 e = 0.
struct ComputedTorque {
  Mechanism::Precomputed precomputed = Mechanism::precompute(Mechanism::default_parameters());

  Mechanism::Inputs operator()(const Mechanism::State& state) const noexcept {
    Mechanism::Accelerations a{};
    for (int i = 0; i < joints; ++i) {
      const auto [amplitude, frequency] = wanted[static_cast<std::size_t>(i)];
      const double s = std::sin(frequency * state.time), c = std::cos(frequency * state.time);
      const double error = state.q[i] - amplitude * s, error_rate = state.v[i] - amplitude * frequency * c;
      a[i] = -amplitude * frequency * frequency * s - 2 * rate * error_rate - rate * rate * error;
    }
    Mechanism::GeneralizedForces forces{};
    Mechanism::inverse_dynamics(precomputed, state, a, {}, forces);
    Mechanism::Inputs inputs{};
    for (int i = 0; i < joints; ++i) inputs[i] = forces[i];
    return inputs;
  }
};

/// e(t) = e_0 (1 + k t) exp(-k t) about what is wanted, in long double: 18 digits.
std::array<double, 2 * joints> state_at(long double t) {
  std::array<double, 2 * joints> y{};
  for (std::size_t i = 0; i < joints; ++i) {
    const long double amplitude = wanted[i].amplitude, frequency = wanted[i].frequency, k = rate, e = first_error[i];
    const long double fading = std::exp(-k * t);
    y[i] = static_cast<double>(amplitude * std::sin(frequency * t) + e * (1 + k * t) * fading);
    y[joints + i] = static_cast<double>(amplitude * frequency * std::cos(frequency * t) - e * k * k * t * fading);
  }
  return y;
}

}  // namespace

Problem ur5() {
  using State = std::array<double, 2 * joints>;
  constexpr double end = 3;
  const Case<Mechanism, 2 * joints, ComputedTorque> motion{
      state_at(0),
      end,
      state_at(end),
      [](const State& y) { return y; },
      std::numeric_limits<double>::infinity(),
      torsor::runtime::equations_of_motion<Mechanism>(Mechanism::default_parameters(), ComputedTorque())};
  return {"ur5", "ur5 under a computed-torque controller, 3 s; the end in closed form", all_ways(motion)};
}

}  // namespace work_precision
