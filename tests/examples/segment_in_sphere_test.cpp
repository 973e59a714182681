// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/segment_in_sphere.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"

namespace torsor::segment_in_sphere_test {
namespace {

using namespace torsor::runtime;
using Segment = segment_in_sphere::Mechanism<double>;
using Vector = std::array<double, 3>;

// The values of the scene.
constexpr double R = 1.0, l = 1.2, m = 1.0, g = 9.81, d = 0.8, rounding = 1.1e-16;

/// The axes x3, y3, z3 of the segment in the fixed axes, by Euler's angles.
std::array<Vector, 3> axes(const Segment::State& s) {
  const double sp = std::sin(s.q.psi), cp = std::cos(s.q.psi), st = std::sin(s.q.theta), ct = std::cos(s.q.theta);
  const double sf = std::sin(s.q.phi), cf = std::cos(s.q.phi);
  return {{{cp * cf - sp * ct * sf, sp * cf + cp * ct * sf, st * sf},
           {-cp * sf - sp * ct * cf, -sp * sf + cp * ct * cf, st * cf},
           {sp * st, -cp * st, ct}}};
}

/// Components of the angular velocity along x3, y3, z3.
Vector rates(const Segment::State& s) {
  const double st = std::sin(s.q.theta), ct = std::cos(s.q.theta), sf = std::sin(s.q.phi), cf = std::cos(s.q.phi);
  return {s.v.psi * st * sf + s.v.theta * cf, s.v.psi * st * cf - s.v.theta * sf, s.v.psi * ct + s.v.phi};
}

std::array<Segment::State, 50> samples() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  std::array<Segment::State, 50> all{};
  for (auto& s : all) {
    for (int i = 0; i < 3; ++i) {
      s.q[i] = uniform(random);
      s.v[i] = uniform(random);
    }
  }
  return all;
}

Segment::Kinematics kinematics(const Segment::State& s) {
  Segment::Kinematics result{};
  Segment::kinematics(Segment::precompute({}), s, result);
  return result;
}

// Twenty roundings of numbers of 1, here and below, unless said otherwise.
TEST(SegmentInSphere, KeepsItsEndsOnTheSphereForAnyValuesOfItsIndependentCoordinates) {
  for (const auto& s : samples()) {
    const auto at = kinematics(s);
    double AB = 0.0;
    for (const auto& [P, V] : {std::pair{at.A_position, at.A_velocity}, {at.B_position, at.B_velocity}}) {
      EXPECT_NEAR(std::hypot(P[0], P[1], P[2]), R, 20 * rounding);
      EXPECT_NEAR(P[0] * V[0] + P[1] * V[1] + P[2] * V[2], 0.0,
                  100 * rounding);  // tangent to the sphere, speeds below 5
    }
    for (std::size_t i = 0; i < 3; ++i) AB += std::pow(at.B_position[i] - at.A_position[i], 2);
    EXPECT_NEAR(std::sqrt(AB), l, 20 * rounding);
  }
}

// dAB/dt = Omega ^ l x3 = l [(psi' cos(theta) + phi') y3 - (psi' sin(theta) cos(phi) - theta' sin(phi)) z3].
TEST(SegmentInSphere, HasTheRateOfABThatTheExerciseAsksFor) {
  for (const auto& s : samples()) {
    const auto at = kinematics(s);
    const auto axis = axes(s);
    const double along_y = l * (s.v.psi * std::cos(s.q.theta) + s.v.phi);
    const double along_z = -l * (s.v.psi * std::sin(s.q.theta) * std::cos(s.q.phi) - s.v.theta * std::sin(s.q.phi));
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(at.B_velocity[i] - at.A_velocity[i], along_y * axis[1][i] + along_z * axis[2][i], 100 * rounding);
    }
  }
}

// Euler's equations about O by hand: J_O = diag(m d², m d² + J, J), J = m l²/12; the moment of the weight is
// d z3 ^ (-m g z0). Generated accelerations are put into p', q', r'.
TEST(SegmentInSphere, MovesAsEulersEquationsSay) {
  const auto motion = equations_of_motion<Segment>();
  const double J = m * l * l / 12.0, A = m * d * d, B = A + J, C = J;
  for (const auto& s : samples()) {
    if (std::abs(std::sin(s.q.theta)) < 0.1) continue;  // Euler's angles lock at 0: not to be asked for digits there
    Segment::Accelerations a{};
    Segment::Multipliers none{};
    ASSERT_EQ(motion.accelerations(s, a, none), Evaluation::ok);
    const double st = std::sin(s.q.theta), ct = std::cos(s.q.theta), sf = std::sin(s.q.phi), cf = std::cos(s.q.phi);
    const auto [p, q, r] = rates(s);
    const double p_rate =
        a.psi * st * sf + s.v.psi * (ct * s.v.theta * sf + st * cf * s.v.phi) + a.theta * cf - s.v.theta * sf * s.v.phi;
    const double q_rate =
        a.psi * st * cf + s.v.psi * (ct * s.v.theta * cf - st * sf * s.v.phi) - a.theta * sf - s.v.theta * cf * s.v.phi;
    const double r_rate = a.psi * ct - s.v.psi * st * s.v.theta + a.phi;
    // A hundred roundings of terms of 100 N m: the accelerations reach 1/sin(theta) times the torques.
    constexpr double tolerance = 100 * 100 * rounding;
    EXPECT_NEAR(A * p_rate + (C - B) * q * r, m * g * d * st * cf, tolerance);
    EXPECT_NEAR(B * q_rate + (A - C) * r * p, -m * g * d * st * sf, tolerance);
    EXPECT_NEAR(C * r_rate + (B - A) * p * q, 0.0, tolerance);
  }
}

TEST(SegmentInSphere, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Segment>(equations_of_motion<Segment>(), 5.0, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.exchanged, 0.5);
}

}  // namespace
}  // namespace torsor::segment_in_sphere_test
