// SPDX-License-Identifier: GPL-3.0-or-later
// The program of someone who wants the header only: no torsor library, no other include.
#include <array>
#include <cstdio>

#include "double_pendulum.hpp"
#include "sliding_arm.hpp"

int main() {
  using Mechanism = double_pendulum::Mechanism<double>;
  const Mechanism::Precomputed precomputed = Mechanism::precompute(Mechanism::default_parameters());
  Mechanism::Accelerations accelerations{};
  Mechanism::Multipliers multipliers{};
  const torsor::Status status = Mechanism::forward_dynamics(precomputed, Mechanism::initial_state(), Mechanism::Inputs{},
                                                            accelerations, multipliers);
  std::printf("accelerations of %s:", Mechanism::name);
  for (int i = 0; i < Mechanism::velocity_count; ++i) std::printf(" %.17g", accelerations[i]);
  std::printf("\n");
  using Arm = sliding_arm::Mechanism<double>;
  std::array<double, 4> mass{};
  Arm::mass_matrix(Arm::precompute(Arm::default_parameters()), Arm::initial_state(), mass);
  std::printf("mass matrix of %s: %.17g %.17g\n", Arm::name, mass[0], mass[1]);
  return status == torsor::Status::ok ? 0 : 1;
}
