// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/tumbler.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::tumbler_test {
namespace {

using namespace torsor::runtime;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Tumbler = tumbler::Mechanism<double>;
using State = StateVector<Tumbler>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scene.
constexpr double R = 0.05, a = 0.02, m = 0.2, A = 0.0002, B = 0.00015, g = 9.81;
const Vector3d z0 = Vector3d::UnitZ();

/// z2 and Omega = psi' z0 + theta' x1 + phi' z2 of Euler's angles, in the axes of the table.
struct Attitude {
  Vector3d axis, omega;
};
Attitude attitude(const Tumbler::State& s) {
  const double cp = std::cos(s.q.psi), sp = std::sin(s.q.psi), ct = std::cos(s.q.theta), st = std::sin(s.q.theta);
  const Vector3d axis(sp * st, -cp * st, ct);
  return {axis, s.v.psi * z0 + s.v.theta * Vector3d(cp, sp, 0) + s.v.phi * axis};
}

/// A state that rolls: V_C = R Omega ∧ z0.
Tumbler::State rolling_state(double psi, double theta, double psi_rate, double theta_rate, double phi_rate) {
  Tumbler::State s{};
  s.q = {0.1, -0.2, R, psi, theta, 0.4};
  s.v = {0.0, 0.0, 0.0, psi_rate, theta_rate, phi_rate};
  const Vector3d velocity = R * attitude(s).omega.cross(z0);
  s.v.x = velocity[0];
  s.v.y = velocity[1];
  return s;
}

Tumbler::State some_state(int i) { return rolling_state(0.7 * i, 0.3 + 0.25 * i, 4 - i, 1.5 * i - 5, 2 + 0.5 * i); }

// z = R; x' - R sin(psi) theta' + R cos(psi) sin(theta) phi' = 0, y' + R cos(psi) theta' + R sin(psi) sin(theta) phi' =
// 0: V(I ∈ C/T) = V_C + Omega ∧ CI = 0 with CI = -R z0. The twist in C is {psi' z0 + theta' x1 + phi' z2; x' x0 + y'
// y0}.
TEST(Tumbler, RollsUnderTheConditionsOfContactAndOfNoSlip) {
  for (int i = 0; i < 8; ++i) {
    Tumbler::State s = some_state(i);
    s.q.z += 0.01 * i;  // anything
    s.v.x += 0.3;
    s.v.y -= 0.2;
    Tumbler::Constraints c{};
    const auto precomputed = Tumbler::precompute(Tumbler::default_parameters());
    Tumbler::constraints(precomputed, s, c);
    const auto [axis, omega] = attitude(s);
    const Vector3d slip = Vector3d(s.v.x, s.v.y, s.v.z) + omega.cross(-R * z0);
    EXPECT_NEAR(c.value[0], s.q.z - R, 1e-16);
    EXPECT_NEAR(c.rate[1], slip[0], 1e-15);
    EXPECT_NEAR(c.rate[2], slip[1], 1e-15);
    EXPECT_NEAR(slip[0],
                s.v.x - R * std::sin(s.q.psi) * s.v.theta + R * std::cos(s.q.psi) * std::sin(s.q.theta) * s.v.phi,
                1e-15);
    EXPECT_NEAR(slip[1],
                s.v.y + R * std::cos(s.q.psi) * s.v.theta + R * std::sin(s.q.psi) * std::sin(s.q.theta) * s.v.phi,
                1e-15);
    Tumbler::Kinematics at{};
    Tumbler::kinematics(precomputed, s, at);
    for (int k = 0; k < 3; ++k) {
      const auto K = static_cast<std::size_t>(k);
      EXPECT_NEAR(at.tumbler_angular_velocity[K], omega[k], 2e-14);
      EXPECT_NEAR(at.I_position[K], (Vector3d(s.q.x, s.q.y, s.q.z) - R * z0)[k], 1e-16);
      EXPECT_NEAR(at.I_velocity[K], (slip + s.v.z * z0)[k], 1e-15);
    }
  }
}

// Newton and Euler by hand, without any angle: m Gamma_G = F - m g z0 and J_G Omega' + Omega ∧ J_G Omega = GI ∧ F with
// Gamma_C = R Omega' ∧ z0, CG = -a z2: three linear equations for Omega'.
TEST(Tumbler, HasTheAccelerationsAndTheReactionOfNewtonAndEuler) {
  const auto motion = equations_of_motion<Tumbler>();
  const auto crossing = [](const Vector3d& v) {
    Matrix3d matrix;
    matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return matrix;
  };
  for (int i = 0; i < 8; ++i) {
    const Tumbler::State s = some_state(i);
    const auto [axis, omega] = attitude(s);
    const Vector3d CG = -a * axis, GI = -R * z0 - CG;
    const Matrix3d J = A * Matrix3d::Identity() + (B - A) * axis * axis.transpose();
    // Gamma_G = G Omega' + c
    const Matrix3d G = -R * crossing(z0) - crossing(CG);
    const Vector3d c = omega.cross(omega.cross(CG));
    const Vector3d rate = (J - m * crossing(GI) * G).inverse() * (GI.cross(m * (c + g * z0)) - omega.cross(J * omega));
    const Vector3d force = m * (G * rate + c + g * z0);
    Tumbler::Accelerations acc{};
    Tumbler::Multipliers reaction{};
    ASSERT_EQ(motion.accelerations(s, acc, reaction), Evaluation::ok);
    // Condition numbers of some 1e4 (kg beside kg m²) and forces below 10: 1e-16 * 1e4 * 10, with a margin of 10.
    EXPECT_NEAR(reaction.X, force[0], 1e-10);
    EXPECT_NEAR(reaction.Y, force[1], 1e-10);
    EXPECT_NEAR(reaction.N, force[2], 1e-10);
    const Vector3d center = R * rate.cross(z0);
    EXPECT_NEAR(acc.x, center[0], 1e-10);
    EXPECT_NEAR(acc.y, center[1], 1e-10);
    EXPECT_NEAR(acc.z, 0.0, 1e-10);
    const double about_z = acc.psi + acc.phi * std::cos(s.q.theta) - s.v.phi * s.v.theta * std::sin(s.q.theta);
    EXPECT_NEAR(about_z, rate[2], 1e-8);
  }
}

// Of a body of revolution on a sphere that rolls: Jellett's L_G · GI, whatever acts at I, and Routh's
// Omega_3 sqrt(A B + m A R² sin²(theta) + m B (R cos(theta) - a)²), thanks to rolling. Each relative to its size, 1e-13
// a step of a thousand.
TEST(Tumbler, ConservesJellettsAndRouthsIntegrals) {
  const auto integrals = [](const Tumbler::State& s) {
    const auto [axis, omega] = attitude(s);
    const Vector3d momentum = A * omega + (B - A) * omega.dot(axis) * axis;
    const double across = R * std::sin(s.q.theta), along = R * std::cos(s.q.theta) - a;
    return std::array<double, 2>{momentum.dot(a * axis - R * z0),
                                 omega.dot(axis) * std::sqrt(A * B + m * A * across * across + m * B * along * along)};
  };
  const auto motion = equations_of_motion<Tumbler>();
  State y = motion.initial();
  const auto before = integrals(unpack<Tumbler>(0.0, y));
  double leaned_least = 10, leaned_most = 0;
  for (int i = 0; i < 50; ++i) {
    y = examples::state_at(motion, y, 0.02 * i, 0.02 * (i + 1), precise);
    const auto s = unpack<Tumbler>(0.0, y);
    const auto now = integrals(s);
    EXPECT_NEAR(now[0], before[0], 1e-10 * std::abs(before[0]));
    EXPECT_NEAR(now[1], before[1], 1e-10 * std::abs(before[1]));
    leaned_least = std::fmin(leaned_least, s.q.theta);
    leaned_most = std::fmax(leaned_most, s.q.theta);
  }
  EXPECT_GT(leaned_most - leaned_least, 0.2);
}

// Let go at rest from 1 rad it rocks in a plane; from the energy, with sin(theta/2) = sin(1/2) sin u,
// t(theta) = ∫ sqrt((A + m (R² + a² - 2 R a cos theta))/(m g a (1 - sin²(1/2) sin²(u)))) du from u to pi/2, by
// Simpson's rule: 400 panels leave 1e-12.
TEST(Tumbler, RocksInAPlaneInTheTimeOfTheEnergyIntegral) {
  constexpr double end = 0.3;
  const double k = std::sin(0.5), from = std::asin(std::sin(end / 2) / k), to = std::asin(1.0);
  const auto integrand = [k](double u) {
    const double half = k * std::sin(u), cosine = 1 - 2 * half * half;
    return std::sqrt((A + m * (R * R + a * a - 2 * R * a * cosine)) / (m * g * a * (1 - half * half)));
  };
  constexpr int panels = 400;
  const double h = (to - from) / panels;
  double time = integrand(from) + integrand(to);
  for (int i = 1; i < panels; ++i) time += (i % 2 == 1 ? 4 : 2) * integrand(from + i * h);
  time *= h / 3;
  const auto motion = equations_of_motion<Tumbler>();
  const State y = examples::state_at(motion, pack<Tumbler>(rolling_state(0.0, 1.0, 0.0, 0.0, 0.0)), 0.0, time, precise);
  const auto s = unpack<Tumbler>(time, y);
  EXPECT_NEAR(s.q.theta, end, 1e-10);
  EXPECT_NEAR(s.q.psi, 0.0, 1e-12);
  EXPECT_NEAR(s.q.y + 0.2, R * (1.0 - end), 1e-10);  // rolls as far as it turns
}

// Small rocking: omega² = m g a/(A + m (R - a)²), to the square of the amplitude; from 0.02 rad to half of it in a
// sixth of a period.
TEST(Tumbler, RocksAtItsNaturalFrequency) {
  const double omega = std::sqrt(m * g * a / (A + m * (R - a) * (R - a))), sixth = std::acos(0.5) / omega;
  const auto motion = equations_of_motion<Tumbler>();
  const State y =
      examples::state_at(motion, pack<Tumbler>(rolling_state(0.0, 0.02, 0.0, 0.0, 0.0)), 0.0, sixth, precise);
  EXPECT_NEAR(y[4], 0.01, 0.02 * 0.02 * 0.02);
}

TEST(Tumbler, MeetsItsCommittedReference) {
  // A hundred steps of 1e-13 of states below 10.
  examples::expect_reference(equations_of_motion<Tumbler>(), "tumbler",
                             {.error = 1e-11, .least_amplification = 1.0, .tolerance = 1e-13});
}

TEST(Tumbler, ObeysTheEnergyTheorem) {
  const auto motion = equations_of_motion<Tumbler>();
  const auto balance = examples::energy_balance<Tumbler>(
      motion, 1.0, 1e-13,
      [&](const Tumbler::State& s, const Tumbler::Accelerations&, const Tumbler::Multipliers& force) {
        Tumbler::Constraints c{};  // what truncation leaves of the slip is worked on
        Tumbler::constraints(motion.precomputed(), s, c);
        return force.N * c.rate[0] + force.X * c.rate[1] + force.Y * c.rate[2];
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-8);
  EXPECT_GT(balance.exchanged, 1e-3);
  EXPECT_LT(balance.work, 1e-9);
}

}  // namespace
}  // namespace torsor::tumbler_test
