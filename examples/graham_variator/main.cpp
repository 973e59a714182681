// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/graham_variator.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Variator = graham_variator::Mechanism<double>;

/// omega3 / omega1 that the two conditions of no slip leave for a place d of the ring: the rates that they allow, from
/// their coefficients, with omega1 = 1.
double ratio(const Variator::Parameters& parameters) {
  Variator::Constraints slip{};
  Variator::constraints(Variator::precompute(parameters), {}, slip);
  constexpr int conditions = Variator::multiplier_count, at_A = 1, at_E = 3;  // those along z1
  const auto entry = [&](int row, int column) {
    return slip.jacobian[static_cast<std::size_t>(row + conditions * column)];
  };
  const double beta = -entry(at_A, 0) / entry(at_A, 1);
  return -(entry(at_E, 0) + entry(at_E, 1) * beta) / entry(at_E, 2);
}

void show(const Reference<double>& reference) {
  std::cout << "Graham variator\n\n"
            << work_precision(equations_of_motion<Variator>(), reference, Midpoint{.step = 1e-4},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  constexpr double c = 0.1, l = 0.03, p = 0.02, delta = std::numbers::pi / 12.0;
  const double r3 = c - l * std::sin(delta) + p * std::cos(delta);
  Table table({"d [m]", "omega1 / omega3", "formula", "omega3 / omega1", "alpha'' of C1 = 1 N m [rad/s^2]", "T_A [N]",
               "T_E [N]"});
  for (const double d : {0.05, 0.06, 0.0669102, 0.08, 0.1, 0.14}) {
    Variator::Parameters parameters = Variator::default_parameters();
    parameters.d = d;
    const auto motion = equations_of_motion<Variator>(parameters, [](const Variator::State&) {
      return Variator::Inputs{1.0, 0.0};
    });
    Variator::Accelerations a{};
    Variator::Multipliers force{};
    (void)motion.accelerations(Variator::initial_state(parameters), a, force);
    const double found = ratio(parameters);
    table.add({scientific(d), scientific(1.0 / found, 6),
               scientific(1.0 / (1.0 - c * p / (r3 * d * std::tan(delta))), 6), scientific(found, 6),
               scientific(a.alpha, 4), scientific(force.T_A), scientific(force.T_E)});
  }
  std::cout << "\nSliding the ring sets the ratio, through a standstill of S3\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "graham_variator", .about = "a ratio set by where a cone rolls in a ring"},
                     show);
}
