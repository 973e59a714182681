// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/watt_governor.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Governor = watt_governor::Mechanism<double>;

/// Where the balls rest: Newton's method on the torque that holds them, with the stiffness of the generated kernel,
/// from beside the bottom.
double rest(const Governor::Precomputed& governor, Governor::Linearisation& linear) {
  Governor::State state{};
  state.q.theta = 1.5;
  for (int i = 0; i < 100; ++i) {
    if (Governor::linearisation(governor, state, {}, {}, {}, linear) != torsor::Status::ok) return NAN;
    const double step = linear.F[0] / linear.K[0];
    state.q.theta += step;
    if (std::abs(step) < 1e-15) break;
  }
  return state.q.theta;
}

void show(const Reference<double>& reference) {
  std::cout << "Watt's governor, let go at 1 rad\n\n"
            << work_precision(equations_of_motion<Governor>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"arms [m]", "sleeve [kg]", "omega [rad/s]", "angle [rad]", "small oscillations [rad/s]"});
  for (const Governor::Parameters& p : {Governor::Parameters{1.0, 0.0, 1.0, 6.283185307179586},
                                        {1.0, 0.0, 1.0, 4.0},
                                        {1.0, 2.0, 0.5, 12.0},
                                        {1.0, 2.0, 0.5, 10.0},
                                        {1.0, 2.0, 0.5, 8.0}}) {
    Governor::Linearisation linear{};
    const double theta = rest(Governor::precompute(p), linear);
    table.add({scientific(p.L), scientific(p.M), scientific(p.omega), scientific(theta, 12),
               scientific(std::sqrt(linear.K[0] / linear.M[0]), 7)});
  }
  std::cout << "\nWhere the balls rest\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "watt_governor", .about = "the angle of the balls against the speed"}, show);
}
