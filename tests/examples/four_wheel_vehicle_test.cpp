// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/four_wheel_vehicle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "generated/four_wheel_vehicle_all_wheels.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/decompositions.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::four_wheel_vehicle_test {
namespace {

using namespace torsor::runtime;
using Vehicle = four_wheel_vehicle::Mechanism<double>;
using AllWheels = four_wheel_vehicle_all_wheels::Mechanism<double>;
using State = StateVector<Vehicle>;
using Angles = std::array<double, 4>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
// The values of the scenes.
const double b = 1, a = b * (std::sqrt(3.0) - 1), r = 0.3;
constexpr double M = 800, J = 900, m = 20, A = 0.5, C = 0.9, c = 3, pi = std::numbers::pi;
const std::array<std::array<double, 2>, 4> O{{{a, b}, {-a, b}, {-a, -b}, {a, -b}}};

AllWheels::Constraints conditions(const Angles& alpha, const AllWheels::State& s) {
  AllWheels::Parameters parameters{};
  for (int i = 0; i < 4; ++i) parameters[i] = alpha[static_cast<std::size_t>(i)];
  AllWheels::Constraints result{};
  AllWheels::constraints(AllWheels::precompute(parameters), s, result);
  return result;
}
/// The columns of the seven rates x', y', psi', phi_i'; those of the wheels' sliding come after them.
torsor::runtime::SingularValues decomposed(const Angles& alpha, double psi) {
  AllWheels::State s{};
  s.q.psi = psi;
  const auto rows = conditions(alpha, s);
  return torsor::runtime::singular_values(Eigen::Map<const Eigen::Matrix<double, 8, 7>>(rows.jacobian.data()));
}

/// Steering whose axes all pass through the point (x, y) of the chassis.
Angles towards(double x, double y) {
  Angles alpha{};
  for (std::size_t i = 0; i < 4; ++i) alpha[i] = std::atan2(y - O[i][1], x - O[i][0]);
  return alpha;
}

// By hand: V(Pi ∈ Ri/Π) = V(Oi ∈ S/R) + r phi_i' y_i, so that along x_i V(Oi) · x_i = 0 and along y_i it gives phi_i'.
TEST(FourWheelVehicle, HasTheConditionsOfNoSlipOfItsWheels) {
  for (int k = 0; k < 6; ++k) {
    AllWheels::State s{};
    for (int i = 0; i < 7; ++i) {  // s_i and its rate are 0
      s.q[i] = 0.3 * i - 0.2 * k;
      s.v[i] = 1.0 - 0.4 * i + 0.3 * k;
    }
    const Angles alpha{0.1 * k, -0.3, 0.2 - 0.1 * k, 0.5};
    const auto rows = conditions(alpha, s);
    for (std::size_t i = 0; i < 4; ++i) {
      const double sp = std::sin(s.q.psi), cp = std::cos(s.q.psi);
      const double x = s.v.x - s.v.psi * (O[i][0] * sp + O[i][1] * cp),
                   y = s.v.y + s.v.psi * (O[i][0] * cp - O[i][1] * sp);
      const double angle = s.q.psi + alpha[i];
      EXPECT_NEAR(rows.rate[2 * i], x * std::cos(angle) + y * std::sin(angle), 1e-14);
      EXPECT_NEAR(rows.rate[2 * i + 1], -x * std::sin(angle) + y * std::cos(angle) + r * s.v[3 + static_cast<int>(i)],
                  1e-14);
    }
  }
}

// The plane motion of the chassis has a center I (or is a translation), and V(Oi) ⊥ OiI: the axes pass through I, and
// the rank is 6; what is left is to turn about I.
TEST(FourWheelVehicle, TurnsAboutThePointWhereTheAxesMeet) {
  for (const auto& [x, y] :
       {std::array{2.5, -1.0}, std::array{-4.0, 0.3}, std::array{0.2, 0.1}, std::array{30.0, 7.0}}) {
    const auto svd = decomposed(towards(x, y), 0.7);
    EXPECT_LT(svd.values[6], 1e-14 * 100);  // rounding of entries up to 1, in 56 of them
    EXPECT_GT(svd.values[5], 1e-3);
    const Eigen::VectorXd v = svd.right.col(6) / svd.right(2, 6);  // psi' = 1: V_C = -z ∧ CI
    const double X = x * std::cos(0.7) - y * std::sin(0.7), Y = x * std::sin(0.7) + y * std::cos(0.7);
    EXPECT_NEAR(v[0], Y, 1e-11 * (1 + std::hypot(X, Y)));
    EXPECT_NEAR(v[1], -X, 1e-11 * (1 + std::hypot(X, Y)));
  }
}

TEST(FourWheelVehicle, TranslatesWhereTheAxesAreParallel) {
  for (const double angle : {0.0, 0.4, -1.2}) {
    const auto svd = decomposed({angle, angle, angle, angle}, -0.3);
    EXPECT_LT(svd.values[6], 1e-12);
    EXPECT_GT(svd.values[5], 1e-3);
    const Eigen::VectorXd v = svd.right.col(6);
    EXPECT_NEAR(v[2], 0.0, 1e-12);
    EXPECT_NEAR(v[0] * std::cos(angle - 0.3) + v[1] * std::sin(angle - 0.3), 0.0, 1e-12);  // along y_i
  }
}

// Necessary too: with one axis turned by delta, or with two pairs of parallel axes, the rank is 7 and nothing moves.
// The seventh singular value grows in proportion to delta.
TEST(FourWheelVehicle, IsBlockedWhereTheAxesDoNotMeet) {
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    const auto smallest = [wheel](double delta) {
      Angles alpha = towards(2.5, -1.2);
      alpha[wheel] += delta;
      return decomposed(alpha, 0.0).values[6];
    };
    EXPECT_GT(smallest(1e-4), 1e-6);
    EXPECT_NEAR(smallest(2e-4) / smallest(1e-4), 2.0, 0.01);
  }
  EXPECT_GT(decomposed({-pi / 4, -pi / 4, 0, 0}, 0.0).values[6], 1e-2);
}

// Question 2: no. At Mi = Pi + s x_i the wheel slips by (Omega ∧ PiMi) = s psi' y_i: nowhere but at Pi, unless the
// vehicle translates.
TEST(FourWheelVehicle, SlipsBesideThePointWhereItDoesNot) {
  const auto motion = equations_of_motion<Vehicle>();
  const auto s = Vehicle::initial_state();
  Vehicle::Kinematics at{};
  Vehicle::kinematics(motion.precomputed(), s, at);
  const auto slip = [&](double along) {
    const double angle = s.q.psi - pi / 4;  // x_1
    const Eigen::Vector3d V(at.wheel_1_velocity[0], at.wheel_1_velocity[1], at.wheel_1_velocity[2]);
    const Eigen::Vector3d omega(at.wheel_1_angular_velocity[0], at.wheel_1_angular_velocity[1],
                                at.wheel_1_angular_velocity[2]);
    const Eigen::Vector3d arm(along * std::cos(angle), along * std::sin(angle), -r);
    return Eigen::Vector3d(V + omega.cross(arm));
  };
  EXPECT_NEAR(slip(0.0).norm(), 0.0, 1e-14);
  for (const double along : {-0.1, 0.03, 0.1}) {
    const Eigen::Vector3d y1(std::sin(pi / 4), std::cos(pi / 4), 0);
    EXPECT_NEAR((slip(along) - along * s.v.psi * y1).norm(), 0.0, 1e-14) << along;
  }
}

// One freedom, to turn by psi' about I: (M |IC|² + J + Σ (m |IOi|² + A + C |IOi|²/r²)) psi'' = -c Σ (|IOi|/r)² psi'.
TEST(FourWheelVehicle, SlowsDownRoundItsCornerAsOneBodyWould) {
  const double I_x = b * (1 + std::sqrt(3.0)), I_y = -b;
  double inertia = M * (I_x * I_x + I_y * I_y) + J, damping = 0;
  for (const auto& [x, y] : O) {
    const double square = (x - I_x) * (x - I_x) + (y - I_y) * (y - I_y);
    inertia += m * square + A + C * square / (r * r);
    damping += c * square / (r * r);
  }
  const double kappa = damping / inertia;
  const auto motion = equations_of_motion<Vehicle>();
  State y = motion.initial();
  for (int i = 1; i <= 10; ++i) {
    y = examples::state_at(motion, y, i - 1.0, i, precise);
    const auto s = unpack<Vehicle>(i, y);
    const double rate = -std::exp(-kappa * i), psi = -(1 - std::exp(-kappa * i)) / kappa;
    // A hundred steps of 1e-13 a second, of coordinates of some 100.
    EXPECT_NEAR(s.v.psi, rate, 1e-10);
    EXPECT_NEAR(s.q.psi, psi, 1e-10);
    // C goes round I, which lies at (I_x, I_y) at the start.
    EXPECT_NEAR(s.q.x, I_x - I_x * std::cos(psi) + I_y * std::sin(psi), 1e-9);
    EXPECT_NEAR(s.q.y, I_y - I_x * std::sin(psi) - I_y * std::cos(psi), 1e-9);
    // All eight conditions hold, those that repeat others included.
    AllWheels::State all{};
    for (int k = 0; k < 7; ++k) {
      all.q[k] = s.q[k];
      all.v[k] = s.v[k];
    }
    for (const double left : conditions({-pi / 4, -pi / 6, 0, 0}, all).rate) EXPECT_NEAR(left, 0.0, 1e-9);
  }
}

// The forces across the wheels are not determined one by one, but their sum is, by the resultant theorem: the mean of
// the wheels is C. Forces of some 3000 N by a solve of condition below 1000.
TEST(FourWheelVehicle, GetsFromTheGroundTheForceThatItsAccelerationTakes) {
  const auto law = [](const Vehicle::State&) { return Vehicle::Inputs{-150.0, -80.0}; };
  const auto motion = equations_of_motion<Vehicle>(Vehicle::default_parameters(), law);
  const Angles alpha{-pi / 4, -pi / 6, 0, 0};
  State y = motion.initial();
  for (int i = 0; i < 5; ++i) {
    const auto s = unpack<Vehicle>(0.3 * i, y);
    Vehicle::Accelerations acceleration{};
    Vehicle::Multipliers lambda{};
    ASSERT_EQ(motion.accelerations(s, acceleration, lambda), Evaluation::ok);
    Eigen::Vector2d force(0, 0);
    for (int wheel = 0; wheel < 4; ++wheel) {
      const double angle = s.q.psi + alpha[static_cast<std::size_t>(wheel)];
      force += lambda[2 * wheel] * Eigen::Vector2d(std::cos(angle), std::sin(angle)) +
               lambda[2 * wheel + 1] * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
    }
    EXPECT_NEAR(force[0], (M + 4 * m) * acceleration.x, 3000 * 1000 * 1.1e-16);
    EXPECT_NEAR(force[1], (M + 4 * m) * acceleration.y, 3000 * 1000 * 1.1e-16);
    EXPECT_GT(force.norm(), 100.0);
    y = examples::state_at(motion, y, 0.3 * i, 0.3 * (i + 1), precise);
  }
}

TEST(FourWheelVehicle, MeetsItsCommittedReference) {
  // A hundred steps of 1e-13 of coordinates of some 10.
  examples::expect_reference(equations_of_motion<Vehicle>(), "four_wheel_vehicle",
                             {.error = 1e-10, .least_amplification = 1.0, .tolerance = 1e-13});
}

// With motors on the rear wheels, the bearings and what truncation leaves of the slip.
TEST(FourWheelVehicle, ObeysTheEnergyTheorem) {
  const auto law = [](const Vehicle::State& s) { return Vehicle::Inputs{-200 * std::cos(2 * s.time), -100.0}; };
  const auto motion = equations_of_motion<Vehicle>(Vehicle::default_parameters(), law);
  const auto balance = examples::energy_balance<Vehicle>(
      motion, 2.0, 1e-12,
      [&](const Vehicle::State& s, const Vehicle::Accelerations&, const Vehicle::Multipliers& lambda) {
        Vehicle::Constraints slip{};
        Vehicle::constraints(motion.precomputed(), s, slip);
        double power = 0;
        for (int j = 0; j < Vehicle::multiplier_count; ++j) power += lambda[j] * slip.rate[static_cast<std::size_t>(j)];
        return power;
      });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-4);
  EXPECT_GT(balance.work, 100.0);
}

}  // namespace
}  // namespace torsor::four_wheel_vehicle_test
