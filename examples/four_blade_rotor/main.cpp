// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/four_blade_rotor.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Rotor = four_blade_rotor::Mechanism<double>;
constexpr double m = 30.0, s = 0.5, l = 5.0, w = 0.4;

void show(const Reference<double>& reference) {
  std::cout << "A rotor of four blades turns freely about its centre\n\n"
            << work_precision(equations_of_motion<Rotor>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-2},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"pitch [rad]", "J_xx [kg m^2]", "J_yy", "J_zz", "products", "J_xx by hand", "J_zz by hand"});
  for (const double alpha : {0.0, 0.2, 0.5, 1.0, 1.5707963267948966}) {
    std::array<double, 9> J{};
    Rotor::mass_matrix(Rotor::precompute({alpha}), Rotor::initial_state(), J);
    const double spans = s * s + s * l + l * l / 3.0, sine = std::sin(alpha), cosine = std::cos(alpha);
    table.add({scientific(alpha), scientific(J[0], 6), scientific(J[4], 6), scientific(J[8], 6),
               scientific(std::fmax(std::abs(J[1]), std::fmax(std::abs(J[2]), std::abs(J[5]))), 0),
               scientific(m * (2.0 * spans + w * w * (1.0 + sine * sine) / 6.0), 6),
               scientific(m * (4.0 * spans + w * w * cosine * cosine / 3.0), 6)});
  }
  std::cout << "\nIts inertia operator in A: the mass matrix\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "four_blade_rotor", .about = "the inertia operator of a rotor, and its free motion"}, show);
}
