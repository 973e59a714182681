// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/whipple_bicycle.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/small_motions/modes.hpp"

namespace {

using namespace torsor::runtime;
using Bicycle = whipple_bicycle::Mechanism<double>;
constexpr double r_R = 0.3, r_F = 0.35;
constexpr int roll = 4, steer = 6;  // places in v

/// Place of a freedom among the independent ones.
template <std::size_t size>
Eigen::Index place(const int (&table)[size], int freedom) {
  return std::find(table, table + size, freedom) - table;
}

/// Roll and steer about steady running straight ahead and upright.
LinearSystem small_motions(double speed) {
  const auto bicycle = Bicycle::precompute({});
  Bicycle::State state = Bicycle::initial_state();
  for (int i = 0; i < Bicycle::velocity_count; ++i) state.v[i] = 0.0;
  state.v.x = speed;
  state.v.rear = -speed / r_R;
  state.v.front = -speed / r_F;
  Bicycle::Accelerations a{};
  Bicycle::Multipliers forces{};
  Bicycle::Linearisation linear{};
  if (Bicycle::forward_dynamics(bicycle, state, {}, a, forces) != torsor::Status::ok ||
      Bicycle::linearisation(bicycle, state, a, forces, {}, linear) != torsor::Status::ok) {
    throw FileError("singular at " + scientific(speed) + " m/s");
  }
  LinearSystem system = undamped(Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero());
  constexpr int rows = Bicycle::independent_velocity_count;
  for (const int j : {0, 1}) {
    const int freedom = j == 0 ? roll : steer;
    const Eigen::Index w = place(Bicycle::independent_velocities, freedom);
    const Eigen::Index e = place(Bicycle::independent_coordinates, freedom);
    for (const int i : {0, 1}) {
      const Eigen::Index row = place(Bicycle::independent_velocities, i == 0 ? roll : steer);
      const auto at = [row](Eigen::Index column) { return static_cast<std::size_t>(column * rows + row); };
      system.M(i, j) = linear.M_r[at(w)];
      system.C(i, j) = linear.C_r[at(w)];
      system.K(i, j) = linear.K_r[at(e)];
    }
  }
  return system;
}

double largest_real_part(double speed, bool oscillating) {
  double largest = -1e9;
  for (const DampedMode& mode : damped_modes(small_motions(speed))) {
    if ((std::abs(mode.eigenvalue.imag()) > 1e-9) == oscillating) largest = std::max(largest, mode.eigenvalue.real());
  }
  return largest;
}

/// The speed in between where a real part changes its sign.
double critical_speed(double below, double above, bool oscillating) {
  const bool sign = largest_real_part(below, oscillating) > 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (largest_real_part(middle, oscillating) > 0.0) == sign ? below = middle : above = middle;
  }
  return 0.5 * (below + above);
}

void show(const Reference<double>& reference) {
  std::cout << "Whipple's bicycle at 4.6 m/s, beginning to fall to the right\n\n"
            << work_precision(equations_of_motion<Bicycle>(), reference, RungeKutta4{.step = 1e-2},
                              DormandPrince54{.relative_tolerance = 1e-8, .absolute_tolerance = 1e-8},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  Table table({"speed [m/s]", "eigenvalues [1/s]", "", "", ""});
  for (int speed = 0; speed <= 10; ++speed) {
    std::vector<std::string> row{std::to_string(speed)};
    for (const DampedMode& mode : damped_modes(small_motions(speed))) {
      const double im = mode.eigenvalue.imag();
      const std::string imaginary =
          std::abs(im) < 1e-9 ? "" : (im > 0 ? " + " : " - ") + scientific(std::abs(im), 10) + "i";
      row.push_back(scientific(mode.eigenvalue.real(), 10) + imaginary);
    }
    table.add(row);
  }
  std::cout << "\nSmall motions about steady running\n\n"
            << table << "\nThe weave becomes stable at " << scientific(critical_speed(4.0, 5.0, true), 14)
            << " m/s, the capsize unstable at " << scientific(critical_speed(5.5, 7.0, false), 14) << " m/s.\n";
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "whipple_bicycle", .about = "a bicycle that rides by itself between two speeds"}, show);
}
