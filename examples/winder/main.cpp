// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/winder.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Winder = winder::Mechanism<double>;

/// The bobbin and the motor along two seconds.
void show_motion(double omega) {
  Winder::Parameters parameters = Winder::default_parameters();
  parameters.omega = omega;
  const auto motion = equations_of_motion<Winder>(parameters);
  auto y = motion.initial();
  Table table({"t [s]", "lambda [m]", "lambda' [m/s]", "own spin [rad/s]", "motor [N m]"});
  for (int i = 0; i <= 8; ++i) {
    const double t = 0.1 * i;
    const auto result = integrate(motion, y, std::max(0.0, t - 0.1), t,
                                  DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto s = unpack<Winder>(t, y);
    Winder::Accelerations a{};
    Winder::Multipliers none{};
    (void)motion.accelerations(s, a, none);
    Winder::Reactions reactions{};
    Winder::reactions(motion.precomputed(), s, a, none, {}, reactions);
    table.add({scientific(t), scientific(s.q.lambda, 6), scientific(s.v.lambda, 6), scientific(s.v.phi, 6),
               scientific(reactions.motor, 6)});
  }
  std::cout << "\nArm at " << scientific(omega) << " rad/s\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Winder, its axis 60 degrees from the vertical\n\n"
            << work_precision(equations_of_motion<Winder>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_motion(10.0);
  show_motion(25.0);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "winder", .about = "a bobbin on a turning arm, and the torque that turns it"},
                     show);
}
