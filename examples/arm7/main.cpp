// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>
#include <string>

#include "generated/arm7.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Arm = arm7::Mechanism<double>;

double sum_of(const Arm::Accelerations& a) { return a.q1 + a.q2 + a.q3 + a.q4 + a.q5 + a.q6 + a.q7; }
double sum_of(const Arm::GeneralizedForces& f) { return f.q1 + f.q2 + f.q3 + f.q4 + f.q5 + f.q6 + f.q7; }

/// Nanoseconds a call takes. Every result is used and moves the next call's state a little, so that no part of a call
/// can be skipped or run ahead.
template <class Call>
double time_of(const Call& call) {
  constexpr int count = 100'000;
  Arm::State state = Arm::initial_state();
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    const double moved = 1e-16 * call(state);
    for (int j = 0; j < Arm::coordinate_count; ++j) state.q[j] += moved;
  }
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return std::isfinite(state.q.q7) ? elapsed.count() / count : NAN;
}

void show_kernels(const Arm::Precomputed& precomputed) {
  Table table({"kernel", "one call [ns]"});
  const auto add = [&](const std::string& name, const auto& call) { table.add({name, scientific(time_of(call))}); };
  const Arm::Accelerations a{1, 2, 3, 4, 5, 6, 7};
  add("inverse_dynamics", [&](const Arm::State& state) {
    Arm::GeneralizedForces forces{};
    Arm::inverse_dynamics(precomputed, state, a, {}, forces);
    return sum_of(forces);
  });
  add("mass_matrix", [&](const Arm::State& state) {
    std::array<double, 49> mass{};
    Arm::mass_matrix(precomputed, state, mass);
    return std::accumulate(mass.begin(), mass.end(), 0.0);
  });
  add("forward_dynamics", [&](const Arm::State& state) {
    Arm::Accelerations result{};
    Arm::Multipliers none{};
    (void)Arm::forward_dynamics(precomputed, state, {}, result, none);
    return sum_of(result);
  });
  std::cout << '\n' << table;
}

/// The motors that hold the arm still against gravity, then with the tip pushed upwards by 10 N: Jᵀ F is taken off.
void show_holding(const Arm::Precomputed& precomputed) {
  const Arm::State start = Arm::initial_state();
  Arm::Kinematics kinematics{};
  Arm::kinematics(precomputed, start, kinematics);
  Arm::GeneralizedForces hold{};
  Arm::bias(precomputed, start, hold);
  std::cout << "\nTip at (" << kinematics.tip_position[0] << ", " << kinematics.tip_position[1] << ", "
            << kinematics.tip_position[2] << ") m\n\n";
  Table table({"joint", "angle [rad]", "holding torque [N m]", "with 10 N upwards on the tip [N m]"});
  for (int i = 0; i < Arm::velocity_count; ++i) {
    const double lift = 10.0 * kinematics.tip_jacobian[static_cast<std::size_t>(3 * i + 2)];
    table.add({std::to_string(i + 1), scientific(start.q[i]), scientific(hold[i], 4), scientific(hold[i] - lift, 4)});
  }
  std::cout << table;
}

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Arm>();
  std::cout << "Arm with seven joints, falling with its motors off\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
  show_holding(motion.precomputed());
  show_kernels(motion.precomputed());
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "arm7", .about = "a seven-joint arm: fall against its reference, holding torques, timings"},
      show);
}
