// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/torque_free_body.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Body = torque_free_body::Mechanism<double>;

/// Turned about each of its principal axes with a small disturbance: how far the axis leaves its direction.
void show_stability() {
  Table table({"turned about", "least share of that axis in 50 s", "|quaternion| - 1"});
  const auto motion = equations_of_motion<Body>();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    StateVector<Body> y{1.0, 0.0, 0.0, 0.0, 1e-4, 1e-4, 1e-4};
    y[4 + axis] = 1.0;
    double least = 1.0;
    const auto result =
        integrate(motion, y, 0.0, 50.0, DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12},
                  [&](double, const StateVector<Body>& now) { least = std::min(least, now[4 + axis]); });
    if (!result) throw FileError(describe(result));
    const double norm = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
    table.add({axis == 0   ? "smallest moment"
               : axis == 1 ? "middle moment"
                           : "largest moment",
               scientific(least, 6), scientific(norm - 1.0)});
  }
  std::cout << "\nMoments 1, 2, 3 kg m^2, disturbed by 1e-4 rad/s\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Rigid body without any torque\n\n"
            << work_precision(equations_of_motion<Body>(), reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_stability();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv,
      {.name = "torque_free_body", .about = "a body left to itself, by a quaternion; it tumbles about one axis"}, show);
}
