// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/chaplygin_sleigh.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Sleigh = chaplygin_sleigh::Mechanism<double>;

/// The sleigh pushed with a speed along its blade and a rate of turning.
void show_run(const std::string& title, double speed, double rate, double until) {
  const auto motion = equations_of_motion<Sleigh>();
  Sleigh::State start{};
  start.v.x = speed;
  start.v.phi = rate;
  auto y = pack<Sleigh>(start);
  Table table({"t [s]", "along the blade [m/s]", "turning [rad/s]", "phi [rad]", "N [N]", "energy [J]"});
  for (int i = 0; i <= 5; ++i) {
    const double t = i * until / 5.0, from = std::max(0.0, t - until / 5.0);
    const auto result =
        integrate(motion, y, from, t, DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto state = unpack<Sleigh>(t, y);
    Sleigh::Accelerations unused{};
    Sleigh::Multipliers edge{};
    (void)motion.accelerations(state, unused, edge);
    Sleigh::FirstIntegrals integrals{};
    Sleigh::first_integrals(motion.precomputed(), state, integrals);
    const double along = state.v.x * std::cos(state.q.phi) + state.v.y * std::sin(state.q.phi);
    table.add({scientific(t), scientific(along, 7), scientific(state.v.phi, 7), scientific(state.q.phi, 7),
               scientific(edge.N), scientific(integrals.energy, 12)});
  }
  std::cout << "\n" << title << "\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Chaplygin's sleigh, spun on the spot\n\n"
            << work_precision(equations_of_motion<Sleigh>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-2}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_run("Spun on the spot: it sets off along its blade", 0.0, 2.0, 5.0);
  show_run("Pushed backwards: it turns round", -1.0, 1e-3, 25.0);
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "chaplygin_sleigh", .about = "a knife edge turns spin into speed, and a sleigh round"},
                     show);
}
