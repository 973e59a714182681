// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include "generated/loading_robot.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Robot = loading_robot::Mechanism<double>;

/// A loading move of two seconds, from rest to rest: each coordinate follows start + travel (s - sin(2 pi s) / 2 pi)
/// with s = t / duration, whose acceleration is continuous.
struct Move {
  static constexpr double duration = 2.0;
  std::array<double, 3> start{0.2, 0.5, -0.6};
  std::array<double, 3> travel{1.1, 0.4, 1.4};

  void at(double t, Robot::State& state, Robot::Accelerations& a) const {
    const double angle = 2.0 * std::numbers::pi * t / duration;
    state.time = t;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      state.q[i] = start[k] + travel[k] * (t / duration - std::sin(angle) / (2.0 * std::numbers::pi));
      state.v[i] = travel[k] / duration * (1.0 - std::cos(angle));
      a[i] = travel[k] * 2.0 * std::numbers::pi / (duration * duration) * std::sin(angle);
    }
  }
};

/// What the motors must give for the move, at any state of it.
Robot::Inputs efforts(const Robot::Precomputed& precomputed, const Robot::State& state, const Robot::Accelerations& a) {
  Robot::GeneralizedForces forces{};
  Robot::inverse_dynamics(precomputed, state, a, {}, forces);
  Robot::Inputs inputs{};
  inputs.C01 = forces.alpha;
  inputs.F12 = forces.x;
  inputs.C23 = forces.beta;
  return inputs;
}

void show_move() {
  const auto precomputed = Robot::precompute(Robot::default_parameters());
  const Move move;
  Table table({"t [s]", "C01 [N m]", "F12 [N]", "C23 [N m]", "Y12 [N]"});
  Robot::State state{};
  Robot::Accelerations a{};
  for (int i = 0; i <= 8; ++i) {
    move.at(0.25 * i, state, a);
    const Robot::Inputs inputs = efforts(precomputed, state, a);
    Robot::Reactions reactions{};
    Robot::reactions(precomputed, state, a, {}, inputs, reactions);
    table.add({std::to_string(state.time).substr(0, 4), scientific(inputs.C01, 3), scientific(inputs.F12, 3),
               scientific(inputs.C23, 3), scientific(reactions.Y12, 3)});
  }
  std::cout << "\nA loading move: motor actions by inverse dynamics, and the reaction of the slide across its axis\n\n"
            << table;

  // The same efforts, as functions of time only, fed to the forward dynamics must produce the move.
  const auto law = [&](const Robot::State& now) {
    Robot::State wanted{};
    Robot::Accelerations acceleration{};
    move.at(now.time, wanted, acceleration);
    return efforts(precomputed, wanted, acceleration);
  };
  const auto motion = equations_of_motion<Robot>(Robot::default_parameters(), law);
  move.at(0.0, state, a);
  auto y = pack<Robot>(state);
  const auto result = integrate(motion, y, 0.0, Move::duration,
                                DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  if (!result) throw FileError(describe(result));
  move.at(Move::duration, state, a);
  const auto wanted = pack<Robot>(state);
  double error = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) error = std::fmax(error, std::abs(y[i] - wanted[i]));
  std::cout << "\nForward dynamics under these actions ends " << scientific(error) << " from the end of the move.\n";
}

void show(const Reference<double>& reference) {
  std::cout << "Press-loading robot, motors off\n\n"
            << work_precision(equations_of_motion<Robot>(), reference, Midpoint{.step = 1e-4},
                              RungeKutta4{.step = 1e-2}, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_move();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv, {.name = "loading_robot", .about = "motor actions and a reaction by inverse dynamics"},
                     show);
}
