// SPDX-License-Identifier: MIT
#include <iostream>
#include <string>

#include "generated/friction_wheels.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Wheels = friction_wheels::Mechanism<double>;

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Wheels>();
  std::cout << "Two friction wheels slowing down\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"t [s]", "V(I/R) [m/s]", "V(I in S1/R)", "V(I in S2/R)", "-r1 omega1", "r2 omega2", "T [N]"});
  auto y = motion.initial();
  for (int i = 0; i <= 4; ++i) {
    const double t = 0.25 * i;
    if (i > 0) {
      const auto result = integrate(motion, y, t - 0.25, t, DormandPrince54{.relative_tolerance = 1e-12});
      if (!result) throw FileError(describe(result));
    }
    const auto state = unpack<Wheels>(t, y);
    Wheels::Kinematics at{};
    Wheels::kinematics(motion.precomputed(), state, at);
    Wheels::Accelerations unused{};
    Wheels::Multipliers force{};
    (void)motion.accelerations(state, unused, force);
    table.add({scientific(t), scientific(at.I_velocity[0], 1), scientific(at.I1_velocity[0], 6),
               scientific(at.I2_velocity[0], 6), scientific(-0.1 * state.v.theta_1, 6),
               scientific(0.3 * state.v.theta_2, 6), scientific(force.T)});
  }
  std::cout << "\nThe point of contact is at rest, the points of the wheels that meet there are not (along x)\n\n"
            << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv,
      {.name = "friction_wheels", .about = "two wheels rolling on each other, and the point where they meet"}, show);
}
