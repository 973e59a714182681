// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "generated/segment_in_sphere.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Segment = segment_in_sphere::Mechanism<double>;

/// |dAB/dt| by the generated velocities, and by the formula that the exercise asks for.
void show_motion() {
  const auto motion = equations_of_motion<Segment>();
  auto y = motion.initial();
  Table table({"t [s]", "psi [rad]", "theta [rad]", "phi [rad]", "|OA| [m]", "|dAB/dt| [m/s]", "by the formula"});
  for (int i = 0; i <= 5; ++i) {
    const auto result = integrate(motion, y, std::max(0.0, i - 1.0), i,
                                  DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
    if (!result) throw FileError(describe(result));
    const auto s = unpack<Segment>(i, y);
    Segment::Kinematics at{};
    Segment::kinematics(motion.precomputed(), s, at);
    const auto& A = at.A_position;
    const double rate = std::hypot(at.B_velocity[0] - at.A_velocity[0], at.B_velocity[1] - at.A_velocity[1],
                                   at.B_velocity[2] - at.A_velocity[2]);
    const double along_y = s.v.psi * std::cos(s.q.theta) + s.v.phi;
    const double along_z = s.v.psi * std::sin(s.q.theta) * std::cos(s.q.phi) - s.v.theta * std::sin(s.q.phi);
    table.add({std::to_string(i), scientific(s.q.psi, 6), scientific(s.q.theta, 6), scientific(s.q.phi, 6),
               scientific(std::hypot(A[0], A[1], A[2]), 15), scientific(rate, 12),
               scientific(1.2 * std::hypot(along_y, along_z), 12)});
  }
  std::cout << "\nThe motion\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Rod sliding inside a sphere\n\n"
            << work_precision(equations_of_motion<Segment>(), reference, Midpoint{.step = 1e-3},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_motion();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "segment_in_sphere", .about = "three independent angles, and the rate of AB"},
                     show);
}
