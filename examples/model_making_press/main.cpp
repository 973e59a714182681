// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/model_making_press_reduced.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Press = model_making_press_reduced::Mechanism<double>;

/// A hand turns the screw by a constant torque from rest: 10 N m/rad of what is pressed stand against it.
void show_pressing(double torque) {
  const auto law = [torque](const Press::State&) {
    Press::Inputs inputs{};
    inputs.C = torque;
    return inputs;
  };
  const auto motion = equations_of_motion<Press>(Press::default_parameters(), law);
  auto y = motion.initial();
  Table table({"t [s]", "turns of the screw", "a_z [mm]", "a_z/omega_z [mm a turn]", "force on the traverse [N]"});
  double t = 0.0;
  for (const double next : {0.1, 0.2, 0.4, 0.8, 1.6, 3.2}) {
    const auto result = integrate(motion, y, t, next, DormandPrince54{.relative_tolerance = 1e-10});
    if (!result) throw FileError(describe(result));
    t = next;
    const auto state = unpack<Press>(t, y);
    Press::Accelerations accelerations{};
    Press::Multipliers multipliers{};
    (void)motion.accelerations(state, accelerations, multipliers);
    constexpr double turn = 6.283185307179586;
    table.add({std::to_string(t).substr(0, 3), std::to_string(state.q.omega_z / turn),
               std::to_string(1e3 * state.q.a_z), scientific(1e3 * turn * state.q.a_z / state.q.omega_z, 12),
               std::to_string(-multipliers.lambda_LB_z)});
  }
  std::cout << "\nThe screw is turned by " << torque << " N m\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Model-making press, reduced to its three joints\n\n"
            << work_precision(equations_of_motion<Press>(), reference, RungeKutta4{.step = 1e-2},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_pressing(-0.2);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv,
      {.name = "model_making_press_reduced", .about = "the screw turns, the traverse follows, a_z = p omega_z"}, show);
}
