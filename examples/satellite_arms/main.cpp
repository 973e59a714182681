// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/satellite_arms.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Satellite = satellite_arms::Mechanism<double>;

/// Deployment by the springs alone, or with the motors holding the arms back by a constant torque.
void show_deployment(double torque) {
  const auto law = [torque](const Satellite::State&) {
    Satellite::Inputs inputs{};
    inputs.Cm2 = -torque;
    inputs.Cm3 = torque;
    return inputs;
  };
  const auto motion = equations_of_motion<Satellite>(Satellite::default_parameters(), law);
  auto y = motion.initial();
  Table table({"t [s]", "theta_2 [deg]", "theta_3 [deg]", "spin [rad/s]", "momentum about z0 [N m s]"});
  double t = 0.0;
  for (const double next : {0.0, 0.1, 0.2, 0.4, 0.8, 1.6, 3.2}) {
    const auto result = integrate(motion, y, t, next, DormandPrince54{.relative_tolerance = 1e-10});
    if (!result) throw FileError(describe(result));
    t = next;
    const auto state = unpack<Satellite>(t, y);
    Satellite::FirstIntegrals integrals{};
    Satellite::first_integrals(motion.precomputed(), state, integrals);
    constexpr double degree = 57.29577951308232;
    table.add({std::to_string(t).substr(0, 4), std::to_string(degree * state.q.theta_2),
               std::to_string(degree * state.q.theta_3), std::to_string(state.v.psi),
               scientific(integrals.momentum_psi, 12)});
  }
  std::cout << "\nDeployment, motors " << (torque == 0.0 ? "off" : "holding back by " + scientific(torque, 1) + " N m")
            << "\n\n"
            << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Satellite whose arms deploy\n\n"
            << work_precision(equations_of_motion<Satellite>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-2}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_deployment(0.0);
  show_deployment(10.0);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "satellite_arms", .about = "arms deploy, the spin slows down, the cyclic momentum stays"},
                     show);
}
