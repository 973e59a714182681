// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/tumbler.hpp"
#include "torsor/runtime/events/contact_regime.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Tumbler = tumbler::Mechanism<double>;

/// One second, every tenth: where it leans and rolls, and what the table gives it.
void show_motion() {
  const auto motion = equations_of_motion<Tumbler>();
  auto y = motion.initial();
  Table table({"t [s]", "x [m]", "y [m]", "theta [rad]", "N [N]", "|X, Y| / N", "slip at I [m/s]", "energy [J]"});
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.1 * i;
    if (i > 0) {
      const auto result =
          integrate(motion, y, t - 0.1, t, DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
      if (!result) throw FileError(describe(result));
    }
    const auto state = unpack<Tumbler>(t, y);
    Tumbler::Accelerations unused{};
    Tumbler::Multipliers reaction{};
    (void)motion.accelerations(state, unused, reaction);
    Tumbler::Kinematics at{};
    Tumbler::kinematics(motion.precomputed(), state, at);
    Tumbler::Energy energy{};
    Tumbler::energy(motion.precomputed(), state, {}, energy);
    table.add({scientific(t, 1), scientific(state.q.x, 6), scientific(state.q.y, 6), scientific(state.q.theta, 6),
               scientific(reaction.N, 4),
               scientific(required_friction(reaction.N, tangential(reaction.X, reaction.Y)), 4),
               scientific(std::hypot(at.I_velocity[0], at.I_velocity[1]), 0),
               scientific(energy.kinetic - energy.force_function, 12)});
  }
  std::cout << "\nThe centre of its base, its lean, and the table's reaction\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "A tumbler pushed sideways\n\n"
            << work_precision(equations_of_motion<Tumbler>(), reference, Midpoint{.step = 1e-4},
                              RungeKutta4{.step = 1e-3}, RungeKutta4{.step = 1e-4},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_motion();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "tumbler", .about = "a weighted half sphere rocks and rolls on a table"},
                     show);
}
