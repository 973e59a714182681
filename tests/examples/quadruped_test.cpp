// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/quadruped.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::quadruped_test {
namespace {

using namespace torsor::runtime;
using Robot = quadruped::Mechanism<double>;
using Vector3 = std::array<double, 3>;

constexpr int first_joint = 7, first_rate = 6;
constexpr double g = 9.81, rounding = 1.1e-16;
constexpr double trunk_mass = 6.0, hip_mass = 0.5, thigh_mass = 0.8, shank_mass = 0.2, foot_mass = 0.06;
constexpr double mass = trunk_mass + 4 * (hip_mass + thigh_mass + shank_mass + foot_mass);

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// One body as the kernel kinematics tells its motion; moments as the file gives them, those of the thighs turned by a
/// quarter about y by hand.
struct Moving {
  double mass;
  Vector3 moments;
  const Vector3 &position, &velocity, &angular_velocity;
  const std::array<double, 9>& rotation;

  /// J w in ground axes: R diag(J) Rᵀ w.
  Vector3 spin() const {
    Vector3 sum{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double along = 0.0;
      for (std::size_t i = 0; i < 3; ++i) along += rotation[3 * axis + i] * angular_velocity[i];
      for (std::size_t i = 0; i < 3; ++i) sum[i] += rotation[3 * axis + i] * moments[axis] * along;
    }
    return sum;
  }
};

#define TORSOR_BODY(name, mass, ...) \
  Moving { mass, {__VA_ARGS__}, at.name##_position, at.name##_velocity, at.name##_angular_velocity, at.name##_rotation }
#define TORSOR_LEG(name)                                                   \
  TORSOR_BODY(name##_hip_link, hip_mass, 0.0006, 0.0004, 0.0006),          \
      TORSOR_BODY(name##_thigh_link, thigh_mass, 0.0028, 0.0028, 0.0004),  \
      TORSOR_BODY(name##_shank_link, shank_mass, 0.0007, 0.0007, 0.00003), \
      TORSOR_BODY(name##_foot, foot_mass, 0.0000096, 0.0000096, 0.0000096)

std::array<Moving, 17> bodies(const Robot::Kinematics& at) {
  return {TORSOR_BODY(trunk, trunk_mass, 0.025, 0.085, 0.1), TORSOR_LEG(front_left), TORSOR_LEG(front_right),
          TORSOR_LEG(rear_left), TORSOR_LEG(rear_right)};
}

/// Centre of mass, its velocity, moment of momentum about it and kinetic energy, summed body by body.
struct Totals {
  Vector3 center{}, velocity{}, momentum{};
  double kinetic = 0.0;
};
Totals totals(const Robot::State& state) {
  Robot::Kinematics at{};
  Robot::kinematics(Robot::precompute(Robot::default_parameters()), state, at);
  Totals sum;
  for (const Moving& body : bodies(at)) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum.center[i] += body.mass * body.position[i] / mass;
      sum.velocity[i] += body.mass * body.velocity[i] / mass;
    }
  }
  for (const Moving& body : bodies(at)) {
    const Vector3 spin = body.spin();
    Vector3 arm{}, impulse{};
    for (std::size_t i = 0; i < 3; ++i) {
      arm[i] = body.position[i] - sum.center[i];
      impulse[i] = body.mass * body.velocity[i];
      sum.kinetic += 0.5 * (impulse[i] * body.velocity[i] + spin[i] * body.angular_velocity[i]);
    }
    const Vector3 moment = cross(arm, impulse);
    for (std::size_t i = 0; i < 3; ++i) sum.momentum[i] += moment[i] + spin[i];
  }
  return sum;
}

/// Motors that pull all joints to other angles: nothing is symmetric.
auto restless() {
  return equations_of_motion<Robot>(Robot::default_parameters(), [](const Robot::State& state) {
    Robot::Inputs torques{};
    for (int joint = 0; joint < Robot::input_count; ++joint) {
      torques[joint] = 10.0 * (0.1 * joint - 0.5 - state.q[first_joint + joint]) - 0.5 * state.v[first_rate + joint];
    }
    return torques;
  });
}

constexpr DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

TEST(Quadruped, HasTheKineticEnergyOfItsBodiesAndTheMassOfTheFile) {
  const auto motion = restless();
  const auto y = examples::state_at(motion, motion.initial(), 0.0, 0.1, precise);
  const Robot::State state = unpack<Robot>(0.1, y);
  Robot::Energy energy{};
  Robot::energy(motion.precomputed(), state, {}, energy);
  const Totals sum = totals(state);
  // Some hundred terms of the size of T on both derivations.
  EXPECT_NEAR(energy.kinetic, sum.kinetic, 200 * rounding * energy.kinetic);
  EXPECT_NEAR(energy.force_function, -mass * g * sum.center[2], 200 * rounding * mass * g);
  std::array<double, 324> matrix{};
  Robot::mass_matrix(motion.precomputed(), state, matrix);
  EXPECT_NEAR(matrix[0], mass, 20 * rounding * mass);
}

// No outer action but weight: the centre of mass falls as a point does, and the moment of momentum about it stays,
// whatever the motors do.
TEST(Quadruped, FallsAsAPointAndKeepsItsMomentOfMomentum) {
  const auto motion = restless();
  const Totals start = totals(Robot::initial_state());
  auto y = motion.initial();
  double turned = 0.0;
  const double end = 0.3;
  const auto result = integrate(motion, y, 0.0, end, precise, [&](double t, const auto& now) {
    turned = std::fmax(turned, std::abs(unpack<Robot>(t, now).v.front_left_thigh));
  });
  ASSERT_TRUE(result) << describe(result);
  EXPECT_GT(turned, 3.0);  // the legs did swing
  const Totals now = totals(unpack<Robot>(end, y));
  // Local errors of 1e-12 (1 + |y|), |y| up to 20 rad/s, that sums of bodies with arms below 1 m take over; rounding is
  // far below. Weighted by masses over 12 kg m and speeds of 20 m/s.
  const double allowed = 21e-12 * 20.0 * std::sqrt(37.0) * static_cast<double>(result.statistics.accepted);
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = i == 2 ? -g : 0.0;
    EXPECT_NEAR(now.velocity[i], start.velocity[i] + weight * end, allowed) << i;
    EXPECT_NEAR(now.center[i], start.center[i] + start.velocity[i] * end + 0.5 * weight * end * end, allowed) << i;
    EXPECT_NEAR(now.momentum[i], start.momentum[i], allowed) << i;
  }
  EXPECT_LT(allowed, 1e-5);
  EXPECT_GT(std::hypot(start.momentum[0], start.momentum[1], start.momentum[2]), 1e-2);
}

// Statics of one leg by hand, in the plane of the leg: the foot at 0.2 (cos a + cos(a + b)) below the hip, the force at
// it upwards. Virtual work of a change of one angle: u = weights less force, each times the rise it works with.
TEST(Quadruped, StandsByTheTorquesOfPlaneStatics) {
  Robot::State state{};
  state.q.trunk_attitude_w = 1.0;
  const double a = 0.7, b = -1.1;
  state.q.front_left_thigh = a;
  state.q.front_left_knee = b;
  const auto precomputed = Robot::precompute(Robot::default_parameters());
  Robot::GeneralizedForces bias{};
  Robot::Kinematics at{};
  Robot::bias(precomputed, state, bias);
  Robot::kinematics(precomputed, state, at);
  const double force = 30.0;
  const auto torque = [&](int freedom) {
    return bias[freedom] - force * at.front_left_foot_origin_jacobian[static_cast<std::size_t>(3 * freedom + 2)];
  };
  const double rise = 0.2 * std::sin(a + b);  // of the foot with the knee; half of it for the shank's centre
  const double knee = (0.5 * shank_mass + foot_mass) * g * rise - force * rise;
  const double swing = std::sin(a);  // of the thigh: 0.2 of it for the knee, 0.09 for the thigh's centre
  const double thigh = knee + (0.09 * thigh_mass + 0.2 * (shank_mass + foot_mass)) * g * swing - force * 0.2 * swing;
  EXPECT_NEAR(torque(first_rate + 2), knee, 50 * rounding * force);
  EXPECT_NEAR(torque(first_rate + 1), thigh, 50 * rounding * force);
  // The hip is 0.08 m inwards of the leg: a foot that rises with it.
  const double hip = (0.04 * hip_mass + 0.08 * (thigh_mass + shank_mass + foot_mass)) * g - 0.08 * force;
  EXPECT_NEAR(torque(first_rate), hip, 50 * rounding * force);
}

TEST(Quadruped, HasTheLimitsOfTheFile) {
  const auto& trunk = Robot::limits[0];
  EXPECT_TRUE(std::isinf(trunk.lower) && trunk.lower < 0 && std::isinf(trunk.upper) && std::isinf(trunk.effort));
  const auto& knee = Robot::limits[first_rate + 2];
  EXPECT_EQ(knee.lower, -2.7);
  EXPECT_EQ(knee.upper, -0.3);
  EXPECT_EQ(knee.velocity, 20);
  EXPECT_EQ(knee.effort, 40);
}

TEST(Quadruped, MeetsItsReference) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/quadruped.reference.csv");
  const auto motion = equations_of_motion<Robot>();
  auto y = motion.initial();
  double t = 0.0, local = 0.0;
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const double next = reference.times[row];
    const auto result = integrate(motion, y, t, next, precise);
    ASSERT_TRUE(result) << describe(result);
    t = next;
    local += 6e-12 * std::sqrt(37.0) * static_cast<double>(result.statistics.accepted);  // |y| stays below 5
    const double allowed = local * growth.until(t);
    const auto expected = reference.state<y.size()>(row);
    EXPECT_LE(examples::largest_difference(y, expected), allowed) << t;
    EXPECT_LT(allowed, 1e-6);
  }
}

TEST(Quadruped, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Robot>(restless(), 0.3, 1e-11);
  examples::expect_kept(balance, 1.0);
  EXPECT_GT(std::abs(balance.work), 0.1);
}

}  // namespace
}  // namespace torsor::quadruped_test
