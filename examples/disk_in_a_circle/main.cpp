// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/disk_in_a_circle.hpp"
#include "torsor/runtime/events/contact_regime.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Disk = disk_in_a_circle::Mechanism<double>;
constexpr double g = 9.81;

/// The disk, the circle of its centre, and how fast it goes round.
struct Round {
  double rho;      ///< radius of the disk [m]
  double R;        ///< radius of the circle [m]
  double h;        ///< height of the centre [m]
  double turning;  ///< [rad/s]
};

/// The state in which G may go round the circle: psi' is what remains to be found.
Disk::State on_the_circle(const Round& round) {
  const auto [rho, R, h, turning] = round;
  const double d = std::sqrt(rho * rho - h * h);
  Disk::State state{};
  state.q.y = -R;
  state.q.z = h;
  state.q.theta = std::asin(h / rho);
  state.v.x = R * turning;
  state.v.psi = turning;
  state.v.phi = -turning * (R + d) / rho;
  return state;
}

/// theta'' there, and the plane's reaction.
double lean_acceleration(const Round& round, Disk::Multipliers& reaction) {
  Disk::Accelerations a{};
  const Disk::Parameters parameters{.rho = round.rho};
  const auto state = on_the_circle(round);
  const auto status = Disk::forward_dynamics(Disk::precompute(parameters), state, {}, a, reaction);
  return status == torsor::Status::ok ? a.theta : std::nan("");
}

/// The rate of turning that keeps the lean: theta'' is even in it and linear in its square.
void add_circle(Table& table, double rho, double R, double h) {
  Disk::Multipliers reaction{};
  const double at_rest = lean_acceleration({rho, R, h, 0.0}, reaction);
  const double slope = lean_acceleration({rho, R, h, 1.0}, reaction) - at_rest;
  const double turning = std::sqrt(-at_rest / slope), d = std::sqrt(rho * rho - h * h);
  const double rest = lean_acceleration({rho, R, h, turning}, reaction);
  const double f = required_friction(reaction.N, tangential(reaction.X, reaction.Y));
  table.add({scientific(rho, 1), scientific(R, 1), scientific(h, 1), scientific(R * turning, 6),
             scientific(R * std::sqrt(4.0 * g * d / (h * (6.0 * R + d))), 6), scientific(reaction.N, 4),
             scientific(f, 6), scientific(4.0 * R * d / (h * (6.0 * R + d)), 6), scientific(rest, 0)});
}

void show(const Reference<double>& reference) {
  const auto motion = equations_of_motion<Disk>();
  std::cout << "A disk rolls while its centre goes round a circle\n\n"
            << work_precision(motion, reference, Midpoint{.step = 1e-4}, RungeKutta4{.step = 1e-2},
                              RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"rho [m]", "R [m]", "h [m]", "speed of G [m/s]", "formula", "N [N]", "f_min", "formula", "theta''"});
  add_circle(table, 2.0, 10.0, 1.0);
  add_circle(table, 2.0, 10.0, 1.9);
  add_circle(table, 2.0, 100.0, 1.9);
  add_circle(table, 0.3, 2.0, 0.25);
  std::cout << "\nSpeed and friction from the reaction computed, beside the formulas of the page\n\n" << table;
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(
      argc, argv,
      {.name = "disk_in_a_circle", .about = "how fast a disk rolls round a circle and what friction it needs"}, show);
}
