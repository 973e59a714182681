// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/nose_radar.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Radar = nose_radar::Mechanism<double>;

/// What the antenna's centre of mass feels while the radar is left to itself.
void show_motion() {
  const auto motion = equations_of_motion<Radar>();
  auto y = motion.initial();
  Table table({"t [s]", "alpha [rad]", "beta [rad]", "V_G - v x [m/s]", "Gamma.x [m/s^2]", "Gamma.x2 [m/s^2]"});
  for (int i = 0; i <= 8; ++i) {
    const double t = 0.25 * i;
    const auto result = integrate(motion, y, std::max(0.0, t - 0.25), t,
                                  DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto s = unpack<Radar>(t, y);
    Radar::Accelerations a{};
    Radar::Multipliers none{};
    (void)motion.accelerations(s, a, none);
    Radar::Kinematics at{};
    Radar::kinematics(motion.precomputed(), s, at);
    Radar::Reactions forces{};
    Radar::reactions(motion.precomputed(), s, a, none, {}, forces);
    const auto& V = at.antenna_velocity;
    constexpr double mass = 12.0;
    table.add({scientific(t), scientific(s.q.alpha, 6), scientific(s.q.beta, 6),
               scientific(std::hypot(V[0] - s.v.x, V[1], V[2]), 9), scientific(forces.F_x / mass, 9),
               scientific(forces.F_x2 / mass, 9)});
  }
  std::cout << "\nMotors off, 200 m/s\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Radar on the nose of an aircraft\n\n"
            << work_precision(equations_of_motion<Radar>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_motion();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "nose_radar", .about = "velocity and two components of the acceleration of an antenna"},
                     show);
}
