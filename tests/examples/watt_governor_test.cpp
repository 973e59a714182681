// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/watt_governor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::watt_governor_test {
namespace {

using namespace torsor::runtime;
using Governor = watt_governor::Mechanism<double>;

constexpr double g = 9.81, pi = std::numbers::pi, rounding = 1.1e-16;

struct Rest {
  double force, stiffness, mass;
};

/// The balls held at an angle: the torque that takes, the stiffness and the mass of small motions.
Rest rest_at(const Governor::Parameters& parameters, double theta) {
  Governor::State state{};
  state.q.theta = theta;
  Governor::GeneralizedForces forces{};
  Governor::Linearisation linear{};
  const auto precomputed = Governor::precompute(parameters);
  Governor::bias(precomputed, state, forces);
  EXPECT_EQ(Governor::linearisation(precomputed, state, {}, {}, {}, linear), torsor::Status::ok);
  return {forces.theta, linear.K[0], linear.M[0]};
}

// By hand: a ball of mass m on a rhombic governor carries half the sleeve twice as far, cos(theta) = (m + M) g/(m L
// omega²). Torques are below 150 N m: ten roundings.
TEST(WattGovernor, RestsAtTheAngleOfTheClosedForm) {
  const Governor::Parameters simple{.m = 1.0, .M = 0.0, .L = 1.0, .omega = 2.0 * pi};
  EXPECT_NEAR(rest_at(simple, 1.319675070268792515727652).force, 0.0, 10 * 150 * rounding);
  const Governor::Parameters rhombic = Governor::default_parameters();
  EXPECT_NEAR(rest_at(rhombic, 1.149712328664586727588102).force, 0.0, 10 * 150 * rounding);
  for (const double omega : {8.0, 11.0, 15.0}) {
    for (const double M : {0.0, 0.5, 1.5}) {
      const Governor::Parameters any{.m = 1.2, .M = M, .L = 0.5, .omega = omega};
      const double cosine = (any.m + M) * g / (any.m * any.L * omega * omega);
      ASSERT_LT(cosine, 1.0);
      EXPECT_NEAR(rest_at(any, std::acos(cosine)).force, 0.0, 10 * 150 * rounding);
      EXPECT_NEAR(rest_at(any, 0.0).force, 0.0, rounding);
    }
  }
}

// With arms of 1 m and no sleeve the balls rise from sqrt(g/L) = 3.13209195 rad/s on; the curvature of -(U + T0) at the
// bottom changes its sign there, and is m L² omega² sin²(theta) for each ball where they then rest (times 2 for both).
TEST(WattGovernor, LiftsItsBallsAboveACriticalSpeed) {
  const auto at = [](double omega, double theta) {
    return rest_at({.m = 1.0, .M = 0.0, .L = 1.0, .omega = omega}, theta);
  };
  EXPECT_GT(at(3.1320, 0.0).stiffness, 0.0);
  EXPECT_LT(at(3.1322, 0.0).stiffness, 0.0);
  EXPECT_NEAR(at(3.132091952673165, 0.0).stiffness, 0.0, 10 * 40 * rounding);
  const double theta = std::acos(g / 16.0);
  EXPECT_NEAR(at(4.0, theta).stiffness, 2.0 * 16.0 * std::pow(std::sin(theta), 2), 10 * 40 * rounding);
}

// Lagrange by hand: T2 = L² (m + 2 M sin²) theta'², T0 = m L² omega² sin², U = 2 (m + M) g L cos.
TEST(WattGovernor, ObeysItsEquationOfMotionAndTheMotorsTorque) {
  const Governor::Parameters p = Governor::default_parameters();
  for (int i = 0; i < 20; ++i) {
    Governor::State s{};
    s.q.theta = 0.15 * i - 1.4;
    s.v.theta = 2.0 - 0.3 * i;
    const double a = 0.5 * i - 4.0, sine = std::sin(s.q.theta), cosine = std::cos(s.q.theta);
    Governor::GeneralizedForces residual{};
    Governor::inverse_dynamics(Governor::precompute(p), s, {a}, {}, residual);
    const double expected = 2.0 * p.L * p.L * (p.m + 2.0 * p.M * sine * sine) * a +
                            4.0 * p.M * p.L * p.L * sine * cosine * s.v.theta * s.v.theta -
                            2.0 * p.m * p.L * p.L * p.omega * p.omega * sine * cosine +
                            2.0 * (p.m + p.M) * g * p.L * sine;
    // Sums of some hundred N m: twenty roundings.
    EXPECT_NEAR(residual.theta, expected, 20 * 100 * rounding);
    Governor::Reactions reactions{};
    Governor::reactions(Governor::precompute(p), s, {a}, {}, {}, reactions);
    EXPECT_NEAR(reactions.motor, 4.0 * p.m * p.L * p.L * p.omega * sine * cosine * s.v.theta, 20 * 100 * rounding);
  }
}

TEST(WattGovernor, ObeysTheEnergyTheoremWithTheMotorsPower) {
  const Governor::Parameters p = Governor::default_parameters();
  const auto balance = examples::energy_balance<Governor>(
      equations_of_motion<Governor>(), 5.0, 1e-12,
      [&](const Governor::State& s, const Governor::Accelerations&, const Governor::Multipliers&) {
        return 2.0 * p.m * p.L * p.L * p.omega * p.omega * std::sin(2.0 * s.q.theta) * s.v.theta;
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 5.0);
}

}  // namespace
}  // namespace torsor::watt_governor_test
