// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/flyball_governor.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Governor = flyball_governor::Mechanism<double>;

/// The slider's height along ten seconds, which is all that was published, and the angular momentum, which stays.
void show_motion() {
  const auto motion = equations_of_motion<Governor>();
  auto y = motion.initial();
  Table table({"t [s]", "s [m]", "beta [rad]", "spin [rad/s]", "angular momentum [kg m^2/s]", "steps"});
  for (int second = 0; second <= 10; ++second) {
    const auto result = integrate(motion, y, std::fmax(0.0, second - 1.0), second,
                                  DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto state = unpack<Governor>(second, y);
    Governor::FirstIntegrals integrals{};
    Governor::first_integrals(motion.precomputed(), state, integrals);
    table.add({std::to_string(second), scientific(state.q.s, 10), scientific(state.q.beta_1, 10),
               scientific(state.v.psi, 10), scientific(integrals.momentum_psi, 13),
               std::to_string(result.statistics.accepted)});
  }
  std::cout << "\nTen seconds\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Stiff flyball governor, its first 20 ms\n\n"
            << work_precision(equations_of_motion<Governor>(), reference, Midpoint{.step = 1e-5},
                              RungeKutta4{.step = 1e-4}, RungeKutta4{.step = 1e-5},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_motion();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "flyball_governor", .about = "a stiff benchmark: slider, angles and spin along ten seconds"},
      show);
}
