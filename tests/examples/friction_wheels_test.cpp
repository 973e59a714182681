// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/friction_wheels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::friction_wheels_test {
namespace {

using namespace torsor::runtime;
using torsor::Real;
using Wheels = friction_wheels::Mechanism<double>;
using State = StateVector<Wheels>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scene; disks turn with m r²/2.
constexpr double r1 = 0.1, r2 = 0.3, J1 = 2 * r1 * r1 / 2, J2 = 18 * r2 * r2 / 2, c = 0.9, rounding = 1.1e-16;

Wheels::Kinematics kinematics(const Wheels::State& s) {
  Wheels::Kinematics at{};
  Wheels::kinematics(Wheels::precompute({}), s, at);
  return at;
}

// V(I/R) = 0, V(I ∈ S1/R) = -r1 omega1 x, V(I ∈ S2/R) = r2 omega2 x at any rates, those that slip included.
TEST(FrictionWheels, TellTheVelocitiesAtTheirContactApart) {
  for (int i = 0; i < 10; ++i) {
    Wheels::State s{};
    s.q = {0.7 * i, 1.1 - 0.9 * i};
    s.v = {3.0 - 0.5 * i, 0.4 * i + 0.2};
    const auto at = kinematics(s);
    const std::array<double, 3> I{0.0, r1, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(at.I_position[k], I[k], rounding);
      EXPECT_NEAR(at.I1_position[k], I[k], 4 * rounding);
      EXPECT_NEAR(at.I2_position[k], I[k], 8 * rounding);
      EXPECT_EQ(at.I_velocity[k], 0.0);
    }
    EXPECT_NEAR(at.I1_velocity[0], -r1 * s.v.theta_1, 8 * rounding);
    EXPECT_NEAR(at.I2_velocity[0], r2 * s.v.theta_2, 8 * rounding);
    for (std::size_t k = 1; k < 3; ++k) {
      EXPECT_NEAR(at.I1_velocity[k], 0.0, 4 * rounding);
      EXPECT_NEAR(at.I2_velocity[k], 0.0, 8 * rounding);
    }
    Wheels::Constraints constraints{};
    Wheels::constraints(Wheels::precompute({}), s, constraints);
    EXPECT_NEAR(constraints.rate[0], at.I1_velocity[0] - at.I2_velocity[0], 8 * rounding);
  }
}

// The same by the wheels' material points followed for a while: a point of S1 that is at I when theta_1 has some value
// goes along a circle of radius r1 about O. Central differences of step 1e-4: 1e-8 r omega³ t²/6, below 1e-8.
TEST(FrictionWheels, MoveTheirMaterialPointsOnCircles) {
  Wheels::State s{};
  s.q = {0.8, -0.3};
  s.v = {5.0, -2.0};
  const auto at = kinematics(s);
  constexpr double h = 1e-4;
  const auto position = [](double x, double y, double angle, double center) {  // of a point given in a wheel's axes
    return std::array<double, 2>{x * std::cos(angle) - y * std::sin(angle),
                                 center + x * std::sin(angle) + y * std::cos(angle)};
  };
  const double x1 = r1 * std::sin(s.q.theta_1), y1 = r1 * std::cos(s.q.theta_1);
  const double x2 = -r2 * std::sin(s.q.theta_2), y2 = -r2 * std::cos(s.q.theta_2);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR((position(x1, y1, s.q.theta_1 + s.v.theta_1 * h, 0)[k] -
                 position(x1, y1, s.q.theta_1 - s.v.theta_1 * h, 0)[k]) /
                    (2 * h),
                at.I1_velocity[k], 1e-7);
    EXPECT_NEAR((position(x2, y2, s.q.theta_2 + s.v.theta_2 * h, r1 + r2)[k] -
                 position(x2, y2, s.q.theta_2 - s.v.theta_2 * h, r1 + r2)[k]) /
                    (2 * h),
                at.I2_velocity[k], 1e-7);
  }
}

// By hand: J1 omega1' = C1 - r1 T and J2 omega2' = -c omega2 - r2 T, the force T of S2 on S1 and -T of S1 on S2 acting
// at I; r1 omega1 + r2 omega2 = 0. Without the motor omega1 = 6 exp(-t): J1 + J2 (r1/r2)² = 0.1 = c (r1/r2)² s.
TEST(FrictionWheels, SlowDownAsNewtonAndEulerSay) {
  const auto motion = equations_of_motion<Wheels>();
  State y = motion.initial();
  for (int i = 0; i < 10; ++i) {
    y = examples::state_at(motion, y, 0.2 * i, 0.2 * (i + 1), precise);
    const auto s = unpack<Wheels>(0.2 * (i + 1), y);
    const double omega1 = 6.0 * std::exp(-s.time);
    EXPECT_NEAR(s.v.theta_1, omega1, 1e-11);
    EXPECT_NEAR(s.v.theta_2, -r1 / r2 * omega1, 1e-11);
    EXPECT_NEAR(r1 * s.q.theta_1 + r2 * s.q.theta_2, 0.0, 1e-11);  // rolling of wheels about fixed axes is integrable
    Wheels::Accelerations a{};
    Wheels::Multipliers force{};
    ASSERT_EQ(motion.accelerations(s, a, force), Evaluation::ok);
    EXPECT_NEAR(force.T, J1 * omega1 / r1, 1e-11);
    EXPECT_NEAR(J2 * a.theta_2, -c * s.v.theta_2 - r2 * force.T, 1e-11);
  }
}

TEST(FrictionWheels, HaveACommittedReferenceThatAgreesWithTheExponentialTo38Digits) {
  const torsor::WorkingDigits working(50);
  for (const char* time : {"1", "2", "5"}) {
    const auto row = examples::reference_digits("friction_wheels", time);
    ASSERT_EQ(row.size(), 4U);
    const Real decay = exp(-Real::parse(time));
    EXPECT_LE(examples::distance(row[0], Real(6) * (Real(1) - decay)), 1e-38);
    EXPECT_LE(examples::distance(row[1], Real(-2) * (Real(1) - decay)), 1e-38);
    EXPECT_LE(examples::distance(row[2], Real(6) * decay), 1e-38);
    EXPECT_LE(examples::distance(row[3], Real(-2) * decay), 1e-38);
  }
}

// A motor of 0.5 N m holds omega1 = C1/(c (r1/r2)²) = 5 rad/s in the end.
TEST(FrictionWheels, KeepTheSpeedThatTheMotorAndTheLoadAgreeOn) {
  const auto law = [](const Wheels::State&) { return Wheels::Inputs{0.5}; };
  const auto motion = equations_of_motion<Wheels>(Wheels::default_parameters(), law);
  const State end = examples::state_at(motion, motion.initial(), 0.0, 40.0, precise);
  EXPECT_NEAR(end[2], 5.0, 1e-11);
}

TEST(FrictionWheels, ObeyTheEnergyTheorem) {
  const auto law = [](const Wheels::State& s) { return Wheels::Inputs{0.3 * std::cos(3.0 * s.time)}; };
  const auto motion = equations_of_motion<Wheels>(Wheels::default_parameters(), law);
  const auto balance = examples::energy_balance<Wheels>(motion, 3.0, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-8);
  EXPECT_GT(balance.work, 1.0);
}

}  // namespace
}  // namespace torsor::friction_wheels_test
