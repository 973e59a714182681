// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/heavy_top.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Top = heavy_top::Mechanism<double>;

/// Where the axis points, and what the motion conserves.
void show_motion() {
  const auto motion = equations_of_motion<Top>();
  auto y = motion.initial();
  Table table({"t [s]", "axis along x0", "y0", "z0", "energy [J]", "momentum about the axis [kg m^2/s]"});
  constexpr double period = 0.74520694761676;  // of the nutation
  for (int i = 0; i <= 6; ++i) {
    const double t = i * period / 4.0;
    const auto result = integrate(motion, y, std::fmax(0.0, t - period / 4.0), t,
                                  DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto state = unpack<Top>(t, y);
    Top::Kinematics at{};
    Top::kinematics(motion.precomputed(), state, at);
    Top::FirstIntegrals integrals{};
    Top::first_integrals(motion.precomputed(), state, integrals);
    table.add({scientific(t, 6), scientific(at.top_position[0], 6), scientific(at.top_position[1], 6),
               scientific(at.top_position[2], 10), scientific(integrals.energy, 12),
               scientific(integrals.momentum_gamma, 12)});
  }
  std::cout << "\nThe axis, every quarter of a nutation\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Heavy top, spun at 150 rad/s\n\n"
            << work_precision(equations_of_motion<Top>(), reference, Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-3},
                              RungeKutta4{.step = 1e-4},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_motion();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "heavy_top", .about = "a fast top nutates from the horizontal to upside down and back"},
                     show);
}
