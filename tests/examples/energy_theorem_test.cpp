// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/examples/energy_theorem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "generated/arm7.hpp"
#include "generated/double_pendulum.hpp"
#include "generated/loading_robot.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "generated/satellite_arms.hpp"
#include "generated/vibration_absorber.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace torsor::energy_theorem_test {

// The energy theorem along a run of the examples whose own tests look at other things.

namespace {

using namespace torsor::runtime;
using examples::energy_balance;
using examples::EnergyBalance;
using examples::expect_kept;

/// Power of the multipliers: what integration leaves of A v, which is zero for the exact motion.
template <class Mechanism, class Motion>
auto power_beside_constraints(const Motion& motion) {
  return [&motion](const typename Mechanism::State& s, const typename Mechanism::Accelerations&,
                   const typename Mechanism::Multipliers& lambda) {
    typename Mechanism::Constraints constraints{};
    Mechanism::constraints(motion.precomputed(), s, constraints);
    double power = 0.0;
    for (int j = 0; j < Mechanism::multiplier_count; ++j)
      power += lambda[j] * constraints.rate[static_cast<std::size_t>(j)];
    return power;
  };
}

TEST(EnergyTheorem, HoldsForTheDoublePendulum) {
  using Pendulum = double_pendulum::Mechanism<double>;
  expect_kept(energy_balance<Pendulum>(equations_of_motion<Pendulum>(), 5.0, 1e-12), 1.0);
}

TEST(EnergyTheorem, HoldsForTheSevenJointArm) {
  using Arm = arm7::Mechanism<double>;
  const auto law = [](const Arm::State& s) {
    Arm::Inputs torques{};
    for (int i = 0; i < Arm::input_count; ++i) torques[i] = 3.0 * std::sin(5.0 * s.time + i) - 0.5 * s.v[i];
    return torques;
  };
  const EnergyBalance balance =
      energy_balance<Arm>(equations_of_motion<Arm>(Arm::default_parameters(), law), 0.5, 1e-12);
  expect_kept(balance, 1.0);
  EXPECT_GT(balance.work, 0.1);
}

TEST(EnergyTheorem, HoldsForTheLoadingRobotAndItsMotors) {
  using Robot = loading_robot::Mechanism<double>;
  const auto law = [](const Robot::State& s) { return Robot::Inputs{200.0, 50.0 * std::cos(s.time), -3.0 * s.v.beta}; };
  const EnergyBalance balance =
      energy_balance<Robot>(equations_of_motion<Robot>(Robot::default_parameters(), law), 1.0, 1e-12);
  expect_kept(balance, 1.0);
  EXPECT_GT(balance.work, 1.0);
}

TEST(EnergyTheorem, HoldsForTheSatelliteWithItsDampersAndMotors) {
  using Satellite = satellite_arms::Mechanism<double>;
  const auto law = [](const Satellite::State& s) { return Satellite::Inputs{8.0 * std::sin(3.0 * s.time), -5.0}; };
  const EnergyBalance balance =
      energy_balance<Satellite>(equations_of_motion<Satellite>(Satellite::default_parameters(), law), 5.0, 1e-12);
  expect_kept(balance, 1.0);
  EXPECT_GT(balance.work, 1.0);
}

TEST(EnergyTheorem, HoldsForTheRollingHoopInBothParametrisations) {
  using Hoop = rolling_hoop::Mechanism<double>;
  using HoopWithForces = rolling_hoop_contact_forces::Mechanism<double>;
  const auto one = equations_of_motion<Hoop>();
  const auto two = equations_of_motion<HoopWithForces>();
  expect_kept(energy_balance<Hoop>(one, 5.0, 1e-12, power_beside_constraints<Hoop>(one)), 0.1);
  expect_kept(energy_balance<HoopWithForces>(two, 5.0, 1e-12, power_beside_constraints<HoopWithForces>(two)), 0.1);
}

// What turns the rotor at omega works with it: by hand, Lagrange's equation of phi gives the torque
// M3 R (X'' cos(phi) + g sin(phi)).
TEST(EnergyTheorem, HoldsForTheVibrationAbsorberAndWhatTurnsItsRotor) {
  using Absorber = vibration_absorber::Mechanism<double>;
  constexpr double M3 = 0.1, R = 0.02, g = 9.81, omega = 10.0;
  const EnergyBalance balance = energy_balance<Absorber>(
      equations_of_motion<Absorber>(), 10.0, 1e-12,
      [&](const Absorber::State& s, const Absorber::Accelerations& a, const Absorber::Multipliers&) {
        const double phi = omega * s.time;
        return omega * M3 * R * (a.X * std::cos(phi) + g * std::sin(phi));
      });
  expect_kept(balance, 0.01);
  EXPECT_GT(balance.work, 1e-3);
}

}  // namespace
}  // namespace torsor::energy_theorem_test
