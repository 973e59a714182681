// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/weather_vane.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Vane = weather_vane::Mechanism<double>;
constexpr double m = 2.0, R = 0.3;

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Vane>();
  std::cout << "A weather vane turns into the wind\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table momentum({"t [s]", "theta [rad]", "theta' [rad/s]", "m V_G y0 [kg m/s]", "z0", "sigma_O x0 [kg m^2/s]", "y0",
                  "z0", "T [J]"});
  Table dynamic({"t [s]", "m Gamma_G x0 [N]", "y0", "z0", "delta_O x0 [N m]", "y0", "z0"});
  auto y = motion.initial();
  for (int i = 0; i <= 5; ++i) {
    const double t = 0.4 * i;
    if (i > 0) {
      const auto result = integrate(motion, y, t - 0.4, t, DormandPrince54{.relative_tolerance = 1e-12});
      if (!result) throw FileError(describe(result));
    }
    const auto state = unpack<Vane>(t, y);
    Vane::Kinematics at{};
    Vane::kinematics(motion.precomputed(), state, at);
    Vane::Energy energy{};
    Vane::energy(motion.precomputed(), state, {}, energy);
    Vane::Accelerations a{};
    Vane::Multipliers none{};
    (void)motion.accelerations(state, a, none);
    Vane::Reactions hinge{};
    Vane::reactions(motion.precomputed(), state, a, none, {}, hinge);
    // sigma_O = J_O Omega: m R^2 (x/4 - y1/(2 pi)) theta'; the hinge's moment about x is not released.
    const double product = m * R * R / (2.0 * std::numbers::pi) * state.v.theta;
    momentum.add({scientific(t, 1), scientific(state.q.theta), scientific(state.v.theta),
                  scientific(m * at.vane_velocity[1]), scientific(m * at.vane_velocity[2]),
                  scientific(m * R * R / 4.0 * state.v.theta), scientific(-product * std::cos(state.q.theta)),
                  scientific(-product * std::sin(state.q.theta)), scientific(energy.kinetic)});
    dynamic.add({scientific(t, 1), scientific(hinge.X), scientific(hinge.Y), scientific(hinge.Z),
                 scientific(m * R * R / 4.0 * a.theta), scientific(hinge.M_y), scientific(hinge.M_z)});
  }
  std::cout << "\nMomentum screw in O and kinetic energy\n\n"
            << momentum << "\nDynamic screw in O: the hinge's reactions\n\n"
            << dynamic;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "weather_vane", .about = "momentum and dynamic screws of a quarter disk on a hinge"}, show);
}
