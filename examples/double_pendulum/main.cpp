// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>

#include "generated/double_pendulum.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Pendulum = double_pendulum::Mechanism<double>;

double energy(const Pendulum::Precomputed& precomputed, const Pendulum::State& state) {
  Pendulum::FirstIntegrals integrals{};
  Pendulum::first_integrals(precomputed, state, integrals);
  return integrals.energy;
}

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Pendulum>();
  std::cout << "Double pendulum released at rest from theta_1 = 2 rad, theta_2 = 2.5 rad\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-3},
                              RungeKutta4{.step = 1e-4}, DormandPrince54{.relative_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});

  // The energy stays although the motion, being chaotic, is soon unknowable: neighbours part e-fold in 0.7 s.
  const double before = energy(motion.precomputed(), Pendulum::initial_state());
  Table table({"method, 100 s", "largest energy error"});
  const auto add = [&](const std::string& name, const auto& method) {
    auto y = motion.initial();
    double worst = 0.0;
    const auto result = integrate(motion, y, 0.0, 100.0, method, [&](double t, const StateVector<Pendulum>& state) {
      const double error = std::abs(energy(motion.precomputed(), unpack<Pendulum>(t, state)) - before);
      worst = std::fmax(worst, error);
    });
    table.add({name, result ? scientific(worst) + " J" : describe(result)});
  };
  add("Runge-Kutta 4, h = 1e-3 s", RungeKutta4{.step = 1e-3});
  add("Dormand-Prince, 1e-9", DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9});
  add("Dormand-Prince, 1e-13", DormandPrince54{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13});
  std::cout << "\nEnergy, " << before << " J at the start:\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "double_pendulum", .about = "a chaotic motion against its reference, and its energy"}, show);
}
