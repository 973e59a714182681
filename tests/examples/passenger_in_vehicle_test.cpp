// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/passenger_in_vehicle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::passenger_in_vehicle_test {
namespace {

using namespace torsor::runtime;
using Passenger = passenger_in_vehicle::Mechanism<double>;
using State = StateVector<Passenger>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scene.
constexpr double V = 15, a = 0.8, b = 0.5, l = 0.6, m1 = 40, m2 = 5, c1 = 0.35, c2 = 0.15, J1 = 1.5, J2 = 0.03,
                 k1 = 600, k2 = 40, d1 = 25, d2 = 0.6, g = 9.81;

Passenger::State some_state(int i) {
  Passenger::State s{};
  s.time = 0.3 * i;
  s.q = {0.2 * i - 0.7, 0.9 - 0.3 * i};
  s.v = {1.0 - 0.4 * i, 0.5 * i - 2.0};
  return s;
}

Passenger::Kinematics kinematics(const Passenger::State& s) {
  Passenger::Kinematics at{};
  Passenger::kinematics(Passenger::precompute(Passenger::default_parameters()), s, at);
  return at;
}

// OK = (V t + a - l sin theta_1) x + (b + l cos theta_1) y. Twenty roundings of numbers below 60.
TEST(PassengerInVehicle, HasItsNeckWhereTheVehicleAndTheTrunkPutIt) {
  for (int i = 0; i < 10; ++i) {
    const auto s = some_state(i);
    const auto at = kinematics(s);
    EXPECT_NEAR(at.K_position[0], V * s.time + a - l * std::sin(s.q.theta_1), 1e-13);
    EXPECT_NEAR(at.K_position[1], b + l * std::cos(s.q.theta_1), 1e-13);
    EXPECT_EQ(at.K_position[2], 0.0);
  }
}

// The twists in I and K: {theta_1' z; V x} and {(theta_1' + theta_2') z; V x - l theta_1' x1}.
TEST(PassengerInVehicle, HasTheTwistsOfTrunkAndHead) {
  for (int i = 0; i < 10; ++i) {
    const auto s = some_state(i);
    const auto at = kinematics(s);
    const std::array<double, 3> V_K{V - l * s.v.theta_1 * std::cos(s.q.theta_1),
                                    -l * s.v.theta_1 * std::sin(s.q.theta_1), 0.0};
    const std::array<double, 3> V_I{V, 0.0, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(at.I_velocity[k], V_I[k], 1e-13);
      EXPECT_NEAR(at.K_velocity[k], V_K[k], 1e-13);
      EXPECT_NEAR(at.trunk_angular_velocity[k], k == 2 ? s.v.theta_1 : 0.0, 1e-15);
      EXPECT_NEAR(at.head_angular_velocity[k], k == 2 ? s.v.theta_1 + s.v.theta_2 : 0.0, 1e-15);
    }
  }
}

// The velocities are the rates of the positions, by central differences along any motion of the angles: h² = 1e-8 times
// third derivatives of some 10.
TEST(PassengerInVehicle, HasVelocitiesThatAreRatesOfPositions) {
  constexpr double h = 1e-4;
  for (int i = 0; i < 10; ++i) {
    const auto s = some_state(i);
    const auto at = kinematics(s);
    const auto moved = [&s](double dt) {
      Passenger::State there = s;
      there.time += dt;
      there.q.theta_1 += dt * s.v.theta_1;
      there.q.theta_2 += dt * s.v.theta_2;
      return kinematics(there);
    };
    const auto after = moved(h), before = moved(-h);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR((after.K_position[k] - before.K_position[k]) / (2 * h), at.K_velocity[k], 1e-6);
      EXPECT_NEAR((after.head_position[k] - before.head_position[k]) / (2 * h), at.head_velocity[k], 1e-6);
      EXPECT_NEAR((after.trunk_position[k] - before.trunk_position[k]) / (2 * h), at.trunk_velocity[k], 1e-6);
    }
  }
}

// Newton and Euler by hand, the moments about K of what acts on the head and about I of what acts on both; the vehicle
// goes at constant speed and counts for nothing. Accelerations of G1 and G2 along x and y.
TEST(PassengerInVehicle, MovesAsNewtonAndEulerSay) {
  const auto motion = equations_of_motion<Passenger>();
  for (int i = 0; i < 10; ++i) {
    const auto s = some_state(i);
    Passenger::Accelerations acc{};
    Passenger::Multipliers none{};
    ASSERT_EQ(motion.accelerations(s, acc, none), Evaluation::ok);
    const double p = s.q.theta_1, q = s.q.theta_1 + s.q.theta_2, w = s.v.theta_1, u = w + s.v.theta_2;
    const double W = acc.theta_1, U = W + acc.theta_2;
    // d²/dt² (-sin p, cos p) = (-W cos p + w² sin p, -W sin p - w² cos p)
    const double x1 = -W * std::cos(p) + w * w * std::sin(p), y1 = -W * std::sin(p) - w * w * std::cos(p);
    const double x2 = -U * std::cos(q) + u * u * std::sin(q), y2 = -U * std::sin(q) - u * u * std::cos(q);
    const double head_x = l * x1 + c2 * x2, head_y = l * y1 + c2 * y2;
    const double about_K = J2 * U + m2 * c2 * (-std::sin(q) * (head_y + g) - std::cos(q) * head_x);
    EXPECT_NEAR(about_K, -k2 * s.q.theta_2 - d2 * s.v.theta_2, 1e-11);
    const double arm_x = -l * std::sin(p) - c2 * std::sin(q), arm_y = l * std::cos(p) + c2 * std::cos(q);
    const double about_I = J1 * W + m1 * c1 * (-std::sin(p) * (c1 * y1 + g) - std::cos(p) * c1 * x1) + J2 * U +
                           m2 * (arm_x * (head_y + g) - arm_y * head_x);
    EXPECT_NEAR(about_I, -k1 * p - d1 * w, 1e-11);
  }
}

// A vehicle at constant speed is an inertial frame: whatever V, the passenger nods in the same way.
TEST(PassengerInVehicle, NodsTheSameAtAnySpeed) {
  Passenger::Parameters parked = Passenger::default_parameters();
  parked.V = 0.0;
  const auto moving = equations_of_motion<Passenger>();
  const auto standing = equations_of_motion<Passenger>(parked);
  const State one = examples::state_at(moving, moving.initial(), 0.0, 2.0, precise);
  const State two = examples::state_at(standing, standing.initial(), 0.0, 2.0, precise);
  EXPECT_LE(examples::largest_difference(one, two), 1e-11);
}

// 1e-13 a step, a hundred steps, times what the flow amplifies.
TEST(PassengerInVehicle, MeetsItsCommittedReference) {
  examples::expect_reference(equations_of_motion<Passenger>(), "passenger_in_vehicle",
                             {.error = 1e-11, .least_amplification = 1.0, .tolerance = 1e-13});
}

// T in the frame of the road: the seat works too. What holds the vehicle at its speed has the power V X, X the force
// along x that gives both bodies their accelerations.
TEST(PassengerInVehicle, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Passenger>(
      equations_of_motion<Passenger>(), 1.0, 1e-12,
      [](const Passenger::State& s, const Passenger::Accelerations& acc, const Passenger::Multipliers&) {
        const double p = s.q.theta_1, q = p + s.q.theta_2, w = s.v.theta_1, u = w + s.v.theta_2;
        const double W = acc.theta_1, U = W + acc.theta_2;
        const double x1 = -W * std::cos(p) + w * w * std::sin(p), x2 = -U * std::cos(q) + u * u * std::sin(q);
        return V * ((m1 * c1 + m2 * l) * x1 + m2 * c2 * x2);
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 1.0);
}

}  // namespace
}  // namespace torsor::passenger_in_vehicle_test
