// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>

#include "generated/turning_slot.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Slot = turning_slot::Mechanism<double>;

/// From rest in a slot that turns at some rate: where the bead is along it, and what the slot does.
void show_run(double omega) {
  const auto motion = equations_of_motion<Slot>({.omega = omega});
  Slot::State start{};
  start.q.x = 0.5;
  start.v.y = 0.5 * omega;
  auto y = pack<Slot>(start);
  Table table({"t [s]", "along the slot [m]", "across it [m]", "N [N]"});
  constexpr int rows = 6;
  for (int i = 0; i <= rows; ++i) {
    const double t = 0.2 * i;
    if (i > 0) {
      const auto result = integrate(projected(motion), y, 0.2 * (i - 1), t,
                                    DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
      if (!result) throw FileError(describe(result));
    }
    const auto state = unpack<Slot>(t, y);
    Slot::Accelerations unused{};
    Slot::Multipliers slot{};
    (void)motion.accelerations(state, unused, slot);
    const double c = std::cos(omega * t), s = std::sin(omega * t);
    table.add({scientific(t), scientific(state.q.x * c + state.q.y * s, 10), scientific(state.q.y * c - state.q.x * s),
               scientific(slot.N, 10)});
  }
  std::cout << "\nThe slot turns at " << omega << " rad/s\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Bead in a turning slot\n\n"
            << work_precision(projected(equations_of_motion<Slot>()), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-2}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  for (const double omega : {2.0, 3.0, 4.0}) show_run(omega);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "turning_slot", .about = "a constraint that depends on time, and its force"},
                     show);
}
