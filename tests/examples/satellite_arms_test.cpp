// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/satellite_arms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::satellite_arms_test {
namespace {

using namespace torsor::runtime;
using Satellite = satellite_arms::Mechanism<double>;

// The values of the scene.
struct Arm {
  double hinge, b, m, A, B, C, K, v, rest;  // hinge at x1 = hinge; springs are at rest at `rest`
};
constexpr double pi = std::numbers::pi;
constexpr Arm arm_2{0.3, 0.5, 2.0, 0.17, 0.168, 0.004, 30.0, 5.0, pi / 2.0};
constexpr Arm arm_3{-0.35, 0.45, 2.5, 0.18, 0.176, 0.005, 35.0, 6.0, -pi / 2.0};
constexpr double m1 = 20.0, b1 = 0.1, C1 = 0.9, g = 9.81;
constexpr double rounding = 1.1e-16;

// An arm turns at psi' z1 + theta' y1 with z1 = cos(theta) z2 - sin(theta) x2, and its centre lies hinge + b sin(theta)
// from the axis z0: moment of inertia of the arm about z0, and about its hinge.
double about_z0(const Arm& arm, double theta) {
  const double sine = std::sin(theta), cosine = std::cos(theta);
  const double distance = arm.hinge + arm.b * sine;
  return arm.A * sine * sine + arm.C * cosine * cosine + arm.m * distance * distance;
}
double about_hinge(const Arm& arm) { return arm.B + arm.m * arm.b * arm.b; }
/// d about_z0 / d theta.
double slope(const Arm& arm, double theta) {
  const double sine = std::sin(theta), cosine = std::cos(theta);
  return 2.0 * cosine * ((arm.A - arm.C) * sine + arm.m * arm.b * (arm.hinge + arm.b * sine));
}

double kinetic(const Satellite::State& s) {
  const double spinning = C1 + about_z0(arm_2, s.q.theta_2) + about_z0(arm_3, s.q.theta_3);
  return 0.5 * (spinning * s.v.psi * s.v.psi + about_hinge(arm_2) * s.v.theta_2 * s.v.theta_2 +
                about_hinge(arm_3) * s.v.theta_3 * s.v.theta_3);
}
double momentum(const Satellite::State& s) {
  return (C1 + about_z0(arm_2, s.q.theta_2) + about_z0(arm_3, s.q.theta_3)) * s.v.psi;
}

/// What the hinge of an arm must supply beside its spring and friction: Lagrange's equation of theta.
double hinge_torque(const Arm& arm, double theta, double rate, double acceleration, double spin) {
  return about_hinge(arm) * acceleration - 0.5 * slope(arm, theta) * spin * spin - arm.m * g * arm.b * std::sin(theta) +
         arm.K * (theta - arm.rest) + arm.v * rate;
}

auto samples() { return examples::random_samples<Satellite>(5); }

TEST(SatelliteArms, HaveTheEnergiesOfTheClosedForm) {
  for (const auto& [s, a] : samples()) {
    Satellite::Energy energy{};
    const Satellite::Inputs motors{0.7, -1.1};
    Satellite::energy(Satellite::precompute({}), s, motors, energy);
    // Sums of some twenty terms up to 20 J (U: up to 240 J).
    EXPECT_NEAR(energy.kinetic, kinetic(s), 20 * 20 * rounding);
    double force_function = -m1 * g * b1;
    for (const auto& [arm, theta] : {std::pair{arm_2, s.q.theta_2}, std::pair{arm_3, s.q.theta_3}}) {
      force_function -= arm.m * g * arm.b * std::cos(theta) + 0.5 * arm.K * std::pow(theta - arm.rest, 2);
    }
    EXPECT_NEAR(energy.force_function, force_function, 20 * 240 * rounding);
    const double power = -arm_2.v * s.v.theta_2 * s.v.theta_2 - arm_3.v * s.v.theta_3 * s.v.theta_3 +
                         motors.Cm2 * s.v.theta_2 + motors.Cm3 * s.v.theta_3;
    EXPECT_NEAR(energy.power, power, 20 * 40 * rounding);
  }
}

TEST(SatelliteArms, ObeyTheEquationsOfTheClosedForm) {
  for (const auto& [s, a] : samples()) {
    Satellite::GeneralizedForces forces{};
    Satellite::inverse_dynamics(Satellite::precompute({}), s, a, {}, forces);
    const double spinning = C1 + about_z0(arm_2, s.q.theta_2) + about_z0(arm_3, s.q.theta_3);
    const double slowing = slope(arm_2, s.q.theta_2) * s.v.theta_2 + slope(arm_3, s.q.theta_3) * s.v.theta_3;
    // Twenty roundings of terms up to 130 N m (the springs).
    constexpr double tolerance = 20 * 130 * rounding;
    EXPECT_NEAR(forces.psi, spinning * a.psi + slowing * s.v.psi, tolerance);
    EXPECT_NEAR(forces.theta_2, hinge_torque(arm_2, s.q.theta_2, s.v.theta_2, a.theta_2, s.v.psi), tolerance);
    EXPECT_NEAR(forces.theta_3, hinge_torque(arm_3, s.q.theta_3, s.v.theta_3, a.theta_3, s.v.psi), tolerance);
  }
}

// psi is cyclic and nothing works with it. Errors of each of some 3000 steps, 1e-13 (1 + |y|) at most with |y| below 8,
// move the momentum by them times its gradient, below 10: 3e-8 if all err alike at the limit, 5e-10 as a random walk.
TEST(SatelliteArms, KeepTheMomentumOfTheCyclicCoordinateWhateverTheMotorsDo) {
  const auto law = [](const Satellite::State& s) {
    return Satellite::Inputs{8.0 * std::sin(3.0 * s.time), -5.0 + 2.0 * s.q.theta_2};
  };
  const auto motion = equations_of_motion<Satellite>(Satellite::default_parameters(), law);
  static_assert(Satellite::first_integral_count == 1);
  const double before = momentum(Satellite::initial_state());
  double worst = 0.0, least_spin = 10.0;
  auto y = motion.initial();
  const auto result =
      integrate(motion, y, 0.0, 5.0, DormandPrince54{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13},
                [&](double t, const StateVector<Satellite>& state) {
                  const auto s = unpack<Satellite>(t, state);
                  Satellite::FirstIntegrals integrals{};
                  Satellite::first_integrals(motion.precomputed(), s, integrals);
                  EXPECT_NEAR(integrals.momentum_psi, momentum(s), 20 * 10 * rounding);
                  worst = std::fmax(worst, std::abs(integrals.momentum_psi - before));
                  least_spin = std::fmin(least_spin, s.v.psi);
                });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(worst, 5e-10);
  EXPECT_LT(least_spin, 0.5 * Satellite::initial_state().v.psi);  // while the spin itself changes a lot
}

TEST(SatelliteArms, MeetTheirCommittedReference) {
  examples::expect_reference(equations_of_motion<Satellite>(), "satellite_arms", {.error = 1e-13});
}

}  // namespace
}  // namespace torsor::satellite_arms_test
