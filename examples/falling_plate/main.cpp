// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/falling_plate.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Plate = falling_plate::Mechanism<double>;

/// The fall, until the plate lies flat: the turn of its edge, and what the plane gives, and where.
void show_fall(const std::string& title, const Plate::Parameters& parameters) {
  const auto motion = equations_of_motion<Plate>(parameters);
  auto y = pack<Plate>(Plate::initial_state(parameters));
  Table table({"t [s]", "beta [rad]", "alpha [rad]", "x of G [m]", "y of G [m]", "N [N]", "N acts at HP = [m]"});
  double t = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const auto s = unpack<Plate>(t, y);
    if (s.q.beta < 0.0) break;
    Plate::Accelerations a{};
    Plate::Multipliers none{};
    (void)motion.accelerations(s, a, none);
    Plate::Reactions plane{};
    Plate::reactions(motion.precomputed(), s, a, none, {}, plane);
    table.add({scientific(t), scientific(s.q.beta, 6), scientific(s.q.alpha, 6), scientific(s.q.x), scientific(s.q.y),
               scientific(plane.N, 6), scientific(-plane.moment / plane.N, 6)});
    const auto result =
        integrate(motion, y, t, t + 0.1, DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    t += 0.1;
  }
  std::cout << "\n" << title << "\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Plate falling with its edge on a smooth plane\n\n"
            << work_precision(equations_of_motion<Plate>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_fall("A triangle: its edge turns", Plate::default_parameters());
  show_fall("A rectangle of the same edge and height: its edge stays parallel to itself",
            {.b = 0.45, .A = 0.0675, .B = 0.03, .F = 0.0});
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "falling_plate", .about = "a plate falls with its edge on a smooth plane"},
                     show);
}
