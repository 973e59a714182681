// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>

#include "generated/andrews_squeezer.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Squeezer = andrews_squeezer::Mechanism<double>;

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Squeezer>();
  std::cout << "Andrews' squeezing mechanism, 0.03 s under a constant torque\n\n"
            << work_precision(motion, reference, RungeKutta4{.step = 1e-5},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"t [s]", "beta [rad]", "Theta [rad]", "gamma [rad]", "beta' [rad/s]", "largest gap of the loops [m]",
               "T - U - M beta [J]"});
  auto y = motion.initial();
  double start = 0.0;
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.005 * i;
    const auto result = integrate(motion, y, std::max(0.0, t - 0.005), t,
                                  DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto state = unpack<Squeezer>(t, y);
    Squeezer::Constraints loops{};
    Squeezer::constraints(motion.precomputed(), state, loops);
    double gap = 0.0;
    for (const double f : loops.value) gap = std::max(gap, std::abs(f));
    Squeezer::Energy energy{};
    Squeezer::energy(motion.precomputed(), state, {}, energy);
    const double balance = energy.kinetic - energy.force_function - 0.033 * state.q.beta;
    if (i == 0) start = balance;
    table.add({scientific(t), scientific(state.q.beta, 13), scientific(state.q.Theta, 13),
               scientific(state.q.gamma, 13), scientific(state.v.beta, 13), scientific(gap),
               scientific(balance - start)});
  }
  std::cout << "\nFurther on, with 1e-12 a step\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "andrews_squeezer", .about = "seven bodies, three loops, one freedom: the IVP Test Set's"},
      show);
}
