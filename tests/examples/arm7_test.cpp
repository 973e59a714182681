// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/arm7.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::arm7_test {
namespace {

using namespace torsor::runtime;
using Arm = arm7::Mechanism<double>;

// An independent inverse dynamics: every vector in the axes of the world, rotation matrices in full, no recursion but
// the sums over the chain. Data as in the file the arm was typed from.
using V = std::array<double, 3>;
using M = std::array<V, 3>;  // rows

V operator+(const V& a, const V& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
V operator-(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
V operator*(double k, const V& a) { return {k * a[0], k * a[1], k * a[2]}; }
double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
V cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
V operator*(const M& m, const V& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
M transpose(const M& m) {
  return {{{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
}
M operator*(const M& a, const M& b) {
  const M columns = transpose(b);
  return transpose({{a * columns[0], a * columns[1], a * columns[2]}});
}

struct Link {
  M R;  // placement of the joint in the parent
  V p;
  double mass;
  V center;
  std::array<double, 6> inertia;  // xx, xy, xz, yy, yz, zz about the centre
};
constexpr M straight{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr M down{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
constexpr M up{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
constexpr std::array<Link, 7> links{{
    {straight,
     {0, 0, 0.333},
     4.970684,
     {0.003875, 0.002081, -0.175},
     {0.70337, -0.000139, 0.006772, 0.70661, 0.019169, 0.009117}},
    {down,
     {0, 0, 0},
     0.646926,
     {-0.003141, -0.02872, 0.003495},
     {0.007962, -0.003925, 0.010254, 0.02811, 0.000704, 0.025995}},
    {up,
     {0, -0.316, 0},
     3.228604,
     {0.027518, 0.039252, -0.066502},
     {0.037242, -0.004761, -0.011396, 0.036155, -0.012805, 0.01083}},
    {up,
     {0.0825, 0, 0},
     3.587895,
     {-0.05317, 0.104419, 0.027454},
     {0.025853, 0.007796, -0.001332, 0.019552, 0.008641, 0.028323}},
    {down,
     {-0.0825, 0.384, 0},
     1.225946,
     {-0.011953, 0.041065, -0.038437},
     {0.035549, -0.002117, -0.004037, 0.029474, 0.000229, 0.008627}},
    {up,
     {0, 0, 0},
     1.666555,
     {0.060149, -0.014117, -0.010517},
     {0.001964, 0.000109, -0.001158, 0.004354, 0.000341, 0.005433}},
    {up,
     {0.088, 0, 0},
     0.735522,
     {0.010517, -0.004252, 0.061597},
     {0.012516, -0.000428, -0.001196, 0.010027, -0.000741, 0.004815}},
}};
constexpr V tip{0.0, 0.0, 0.107};
constexpr double g = 9.81;

struct Motion {
  Arm::State state{};
  Arm::Accelerations a{};
};

struct Pose {
  M R;                                             // axes of the link in the world
  V origin, omega, alpha, velocity, acceleration;  // of the link's origin
};

std::array<Pose, 7> poses(const Motion& motion) {
  std::array<Pose, 7> all;
  Pose parent{straight, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < 7; ++i) {
    const int k = static_cast<int>(i);
    const double c = std::cos(motion.state.q[k]), s = std::sin(motion.state.q[k]);
    Pose& link = all[i];
    const V arm = parent.R * links[i].p;
    const M placed = parent.R * links[i].R;
    link.R = placed * M{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
    link.origin = parent.origin + arm;
    link.velocity = parent.velocity + cross(parent.omega, arm);
    link.acceleration = parent.acceleration + cross(parent.alpha, arm) + cross(parent.omega, cross(parent.omega, arm));
    const V axis = placed * V{0, 0, 1};
    link.omega = parent.omega + motion.state.v[k] * axis;
    link.alpha = parent.alpha + motion.a[k] * axis + motion.state.v[k] * cross(parent.omega, axis);
    parent = link;
  }
  return all;
}

/// Torque of joint i: axis . sum over the links it carries of (moment of m (a - g) at the joint + rate of momentum).
std::array<double, 7> torques(const Motion& motion) {
  const auto all = poses(motion);
  std::array<double, 7> result{};
  for (std::size_t j = 0; j < 7; ++j) {
    const Pose& link = all[j];
    const auto& J = links[j].inertia;
    const M local{{{J[0], J[1], J[2]}, {J[1], J[3], J[4]}, {J[2], J[4], J[5]}}};
    const M inertia = link.R * local * transpose(link.R);
    const V arm = link.R * links[j].center;
    const V acceleration = link.acceleration + cross(link.alpha, arm) + cross(link.omega, cross(link.omega, arm));
    const V force = links[j].mass * (acceleration + V{0, 0, g});
    const V moment = inertia * link.alpha + cross(link.omega, inertia * link.omega);
    for (std::size_t i = 0; i <= j; ++i) {
      const V axis = all[i].R * V{0, 0, 1};
      result[i] += dot(axis, moment + cross(link.origin + arm - all[i].origin, force));
    }
  }
  return result;
}

std::array<Motion, 100> motions() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0);
  std::array<Motion, 100> all;
  for (Motion& motion : all) {
    for (int i = 0; i < 7; ++i) {
      motion.state.q[i] = uniform(random);
      motion.state.v[i] = uniform(random);
      motion.a[i] = uniform(random);
    }
  }
  return all;
}

template <class A, class B>
double relative_difference(const A& a, const B& b) {
  double difference = 0.0, size = 0.0;
  for (unsigned char i = 0; i < 7; ++i) {  // fits the index of either type
    const double expected = b[i];
    difference += std::pow(a[i] - expected, 2);
    size += expected * expected;
  }
  return std::sqrt(difference / size);
}

// Some five hundred operations each way, whose roundings of 1.1e-16 accumulate like a random walk over torques that are
// small beside their terms by at most ten: 1e-13 is what is asked of the kernels against exact arithmetic, too.
TEST(Arm7, HasTheTorquesOfAnIndependentNewtonEulerInTheWorldFrame) {
  const auto precomputed = Arm::precompute({});
  for (const Motion& motion : motions()) {
    Arm::GeneralizedForces forces{};
    Arm::inverse_dynamics(precomputed, motion.state, motion.a, {}, forces);
    EXPECT_LT(relative_difference(forces, torques(motion)), 1e-13);
    Motion still = motion;
    still.a = {};
    Arm::bias(precomputed, motion.state, forces);
    EXPECT_LT(relative_difference(forces, torques(still)), 1e-13);
  }
}

TEST(Arm7, HasTheMassMatrixWhoseColumnsAreTorquesOfUnitAccelerations) {
  const auto precomputed = Arm::precompute({});
  for (const Motion& motion : motions()) {
    std::array<double, 49> mass{};
    Arm::mass_matrix(precomputed, motion.state, mass);
    Motion still = motion;
    still.a = {};
    const auto bias = torques(still);
    for (int j = 0; j < 7; ++j) {
      Motion unit = still;
      unit.a[j] = 1.0;
      const auto column = torques(unit);
      for (std::size_t i = 0; i < 7; ++i) {
        // The bias, up to 400 N m, cancels in the difference.
        EXPECT_NEAR(mass[7 * static_cast<std::size_t>(j) + i], column[i] - bias[i], 1e-13 * 400);
      }
    }
  }
}

// Put back into the independent equations, the accelerations found must need the very torques that were given: the
// factorisation's backward error is some roundings of the largest torques, whatever the condition number.
TEST(Arm7, AcceleratesAsItsTorquesDemand) {
  const auto precomputed = Arm::precompute({});
  for (const Motion& motion : motions()) {
    const auto given = torques(motion);
    Arm::Inputs motors{};
    for (int i = 0; i < 7; ++i) motors[i] = given[static_cast<std::size_t>(i)];
    Motion found = motion;
    Arm::Multipliers none{};
    ASSERT_EQ(Arm::forward_dynamics(precomputed, motion.state, motors, found.a, none), torsor::Status::ok);
    EXPECT_LT(relative_difference(torques(found), given), 1e-13);
  }
}

TEST(Arm7, KnowsWhereItsTipIsAndHowItMoves) {
  const auto precomputed = Arm::precompute({});
  for (const Motion& motion : motions()) {
    Arm::Kinematics kinematics{};
    Arm::kinematics(precomputed, motion.state, kinematics);
    const Pose last = poses(motion)[6];
    const V arm = last.R * tip;
    const V position = last.origin + arm, velocity = last.velocity + cross(last.omega, arm);
    for (std::size_t i = 0; i < 3; ++i) {
      // Positions below 1.3 m and rates below 25 m/s after some fifty products.
      EXPECT_NEAR(kinematics.tip_position[i], position[i], 50 * 1.3 * 1.1e-16);
      EXPECT_NEAR(kinematics.tip_velocity[i], velocity[i], 50 * 25 * 1.1e-16);
      EXPECT_NEAR(kinematics.link7_angular_velocity[i], last.omega[i], 50 * 21 * 1.1e-16);
      double by_jacobian = 0.0;
      for (std::size_t j = 0; j < 7; ++j) {
        by_jacobian += kinematics.tip_jacobian[3 * j + i] * motion.state.v[static_cast<int>(j)];
        EXPECT_NEAR(kinematics.link7_rotation[3 * i + j % 3], last.R[j % 3][i], 50 * 1.1e-16);
      }
      EXPECT_NEAR(by_jacobian, velocity[i], 50 * 25 * 1.1e-16);
    }
  }
}

TEST(Arm7, MeetsItsCommittedReference) {
  // Some 300 steps whose roundings the mass matrix's condition multiplies, times what the flow amplifies.
  examples::expect_reference(equations_of_motion<Arm>(), "arm7", {.error = 1e-13});
}

}  // namespace
}  // namespace torsor::arm7_test
