// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/passenger_in_vehicle.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Passenger = passenger_in_vehicle::Mechanism<double>;

std::string in_plane(const std::array<double, 3>& v) { return scientific(v[0], 4) + ", " + scientific(v[1], 4); }

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Passenger>();
  std::cout << "A passenger nods when the brakes are let go\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"t [s]", "OK along x, y [m]", "omega of S1 [rad/s]", "V(I in S1/R) [m/s]", "omega of S2 [rad/s]",
               "V(K in S2/R) [m/s]"});
  auto y = motion.initial();
  for (int i = 0; i <= 5; ++i) {
    const double t = 0.1 * i;
    if (i > 0) {
      const auto result = integrate(motion, y, t - 0.1, t, DormandPrince54{.relative_tolerance = 1e-12});
      if (!result) throw FileError(describe(result));
    }
    Passenger::Kinematics at{};
    Passenger::kinematics(motion.precomputed(), unpack<Passenger>(t, y), at);
    table.add({scientific(t, 1), in_plane(at.K_position), scientific(at.trunk_angular_velocity[2], 4),
               in_plane(at.I_velocity), scientific(at.head_angular_velocity[2], 4), in_plane(at.K_velocity)});
  }
  std::cout << "\nWhere K is, and the twists of trunk and head relative to the road\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "passenger_in_vehicle", .about = "trunk and head of a passenger in a moving vehicle"}, show);
}
