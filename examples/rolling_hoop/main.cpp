// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "generated/rolling_hoop.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Hoop = rolling_hoop::Mechanism<double>;
using HoopWithForces = rolling_hoop_contact_forces::Mechanism<double>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

/// The contact forces along ten seconds, and how far the two parametrisations part.
void compare_parametrisations() {
  const auto with_multipliers = equations_of_motion<Hoop>();
  const auto with_forces = equations_of_motion<HoopWithForces>();
  auto y = with_multipliers.initial();
  auto z = with_forces.initial();
  Table table({"t [s]", "X_F [N]", "Y_F [N]", "N [N]", "|X_F, Y_F| / N", "motions differ by", "lambda - force [N]"});
  for (int second = 0; second <= 10; second += 2) {
    const double from = std::max(0.0, second - 2.0);
    const auto one = integrate(with_multipliers, y, from, second, RungeKutta4{.step = 1e-3});
    const auto two = integrate(with_forces, z, from, second, RungeKutta4{.step = 1e-3});
    if (!one || !two) throw FileError(describe(one ? two : one));
    const auto compatible = unpack<Hoop>(second, y);
    const auto incompatible = unpack<HoopWithForces>(second, z);
    Hoop::Accelerations unused{};
    Hoop::Multipliers lambda{};
    HoopWithForces::Accelerations unused_too{};
    HoopWithForces::Multipliers force{};
    (void)with_multipliers.accelerations(compatible, unused, lambda);
    (void)with_forces.accelerations(incompatible, unused_too, force);
    double difference = 0.0;
    for (int i = 0; i < Hoop::coordinate_count; ++i) {
      const int j = i < 2 ? i : i + 1;  // z is the coordinate that the first parametrisation does without
      difference = std::max(
          {difference, std::abs(compatible.q[i] - incompatible.q[j]), std::abs(compatible.v[i] - incompatible.v[j])});
    }
    const double other = std::max(std::abs(lambda[0] - force.X_F), std::abs(lambda[1] - force.Y_F));
    table.add({std::to_string(second), scientific(force.X_F), scientific(force.Y_F), scientific(force.N),
               scientific(std::hypot(force.X_F, force.Y_F) / force.N), scientific(difference), scientific(other)});
  }
  std::cout << "\nWhat the plane must give, hence the friction that rolling needs; two parametrisations compared\n\n"
            << table;
}

/// A disc that leans by `lean` and goes round once in 2 pi / rate seconds: where its contact point ends. The spin is
/// the one that balances gravity, R = m = 1, g = 9.81.
void add_circle(Table& table, double lean, double rate) {
  Hoop::Parameters disc = Hoop::default_parameters();
  disc.A = 0.25;
  disc.C = 0.5;
  const double turning = rate * std::cos(lean);
  const double rolling = (turning * turning * std::tan(lean) - 4.0 * 9.81 * std::sin(lean)) / (6.0 * turning);
  Hoop::State start{};
  start.q.theta = std::numbers::pi / 2.0 + lean;
  start.q.y = std::cos(start.q.theta);  // the contact point at the origin
  start.v.psi = rate;
  start.v.phi = -rolling - rate * std::cos(start.q.theta);
  start.v.x = rolling;
  auto y = pack<Hoop>(start);
  const auto motion = equations_of_motion<Hoop>(disc);
  const auto result = integrate(motion, y, 0.0, 2.0 * std::numbers::pi / rate, precise);
  if (!result) throw FileError(describe(result));
  const auto end = unpack<Hoop>(result.time, y);
  const double x = end.q.x + std::cos(end.q.theta) * std::sin(end.q.psi);
  const double y_contact = end.q.y - std::cos(end.q.theta) * std::cos(end.q.psi);
  table.add({scientific(lean), scientific(rate), scientific(std::abs(rolling / rate - std::sin(lean)), 4),
             scientific(std::hypot(x, y_contact)), std::to_string(result.statistics.accepted)});
}

void show(const Reference<double>& reference) {
  std::cout << "Hoop rolling without slipping, from a lean of 1.2 rad\n\n"
            << work_precision(equations_of_motion<Hoop>(), reference, Midpoint{.step = 1e-3}, RungeKutta4{.step = 1e-2},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9}, precise);
  compare_parametrisations();
  Table circles({"lean [rad]", "turning [rad/s]", "radius of the circle [m]", "missed after a turn by [m]", "steps"});
  add_circle(circles, 0.3, 1.0);
  add_circle(circles, 0.2, 0.5);
  add_circle(circles, 0.35, 3.0);
  std::cout << "\nDisc on steady circles: the point of contact comes back\n\n" << circles;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv, {.name = "rolling_hoop", .about = "rolling by multipliers and by contact forces; a disc on circles"},
      show);
}
