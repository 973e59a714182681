// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <string>

#include "generated/quadruped.hpp"
#include "torsor/runtime/integration/demonstration.hpp"
#include "torsor/runtime/integration/work_precision.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {

using namespace torsor::runtime;
using Robot = quadruped::Mechanism<double>;

constexpr int legs = 4, first_joint = 7, first_rate = 6;  // places of the joints in q and in v, three to a leg
constexpr double degree = 57.29577951308232;

/// Crouching at rest, level, its hips straight.
Robot::State stance() {
  Robot::State state{};
  state.q.trunk_attitude_w = 1.0;
  for (int leg = 0; leg < legs; ++leg) {
    state.q[first_joint + 3 * leg + 1] = 0.7;
    state.q[first_joint + 3 * leg + 2] = -1.4;
  }
  return state;
}

/// Motors that hold it up: bias = u + Σ Jᵀ F with vertical forces at the feet, equal on both sides. Of the trunk's six
/// equations the vertical force and the moment about y say how front and rear share the weight.
void show_stance() {
  const auto precomputed = Robot::precompute(Robot::default_parameters());
  const Robot::State state = stance();
  Robot::GeneralizedForces bias{};
  Robot::Kinematics at{};
  Robot::bias(precomputed, state, bias);
  Robot::kinematics(precomputed, state, at);
  const std::array<const std::array<double, 54>*, legs> jacobian{
      &at.front_left_foot_origin_jacobian, &at.front_right_foot_origin_jacobian, &at.rear_left_foot_origin_jacobian,
      &at.rear_right_foot_origin_jacobian};
  const auto along_z = [&jacobian](int leg, int freedom) {
    return (*jacobian[static_cast<std::size_t>(leg)])[static_cast<std::size_t>(3 * freedom + 2)];
  };
  const double front_arm = along_z(0, 4), rear_arm = along_z(2, 4);  // of a rising foot about y, freedom 4
  const double front = (bias[4] - 0.5 * bias[2] * 2.0 * rear_arm) / (2.0 * (front_arm - rear_arm));
  const double rear = 0.5 * bias[2] - front;
  Table table({"leg", "force [N]", "hip [N m]", "thigh [N m]", "knee [N m]"});
  for (int leg : {0, 2}) {
    const double force = leg < 2 ? front : rear;
    std::array<double, 3> torque{};
    for (int k = 0; k < 3; ++k) {
      const int freedom = first_rate + 3 * leg + k;
      torque[static_cast<std::size_t>(k)] = bias[freedom] - force * along_z(leg, freedom);
    }
    table.add({leg < 2 ? "front, left" : "rear, left", scientific(force, 4), scientific(torque[0], 4),
               scientific(torque[1], 4), scientific(torque[2], 4)});
  }
  std::cout << "\nStanding on four feet, weight " << scientific(bias[2], 5) << " N\n\n" << table;
}

/// In free fall the motors swing all thighs forward: what the trunk does meanwhile.
void show_fall() {
  const auto law = [](const Robot::State& state) {
    Robot::Inputs torques{};
    const Robot::State rest = stance();
    for (int joint = 0; joint < Robot::input_count; ++joint) {
      const double target = rest.q[first_joint + joint] - (joint % 3 == 1 ? 1.0 : 0.0);  // -1 rad about y is forward
      torques[joint] = 20.0 * (target - state.q[first_joint + joint]) - 1.0 * state.v[first_rate + joint];
    }
    return torques;
  };
  const auto motion = equations_of_motion<Robot>(Robot::default_parameters(), law);
  auto y = pack<Robot>(stance());
  Table table({"t [s]", "height [m]", "thigh [deg]", "trunk's pitch [deg]"});
  double t = 0.0;
  for (const double next : {0.0, 0.05, 0.1, 0.2, 0.3, 0.4}) {
    const auto result = integrate(motion, y, t, next, DormandPrince54{.relative_tolerance = 1e-10});
    if (!result) throw FileError(describe(result));
    t = next;
    const auto state = unpack<Robot>(t, y);
    const double pitch = 2.0 * std::atan2(state.q.trunk_attitude_y, state.q.trunk_attitude_w);
    table.add({std::to_string(t).substr(0, 4), std::to_string(state.q.trunk_z),
               std::to_string(degree * state.q.front_left_thigh), std::to_string(degree * pitch)});
  }
  std::cout << "\nFalling from rest, the thighs swing forward by 57 degrees\n\n" << table;
}

void show(const Reference<double>& reference) {
  std::cout << "Quadruped, read from a URDF file\n\n"
            << work_precision(equations_of_motion<Robot>(), reference, RungeKutta4{.step = 1e-3},
                              DormandPrince54{.relative_tolerance = 1e-6, .absolute_tolerance = 1e-6},
                              DormandPrince54{.relative_tolerance = 1e-9, .absolute_tolerance = 1e-9},
                              DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12});
  show_stance();
  show_fall();
}

}  // namespace

int main(int argc, char** argv) {
  return demonstrate(argc, argv,
                     {.name = "quadruped", .about = "what holds it up, and what its legs do to it in the air"}, show);
}
