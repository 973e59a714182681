// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/bead_on_hoop.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::bead_on_hoop_test {
namespace {

using namespace torsor::runtime;
using Bead = bead_on_hoop::Mechanism<double>;
using State = StateVector<Bead>;

// The values of the scene.
constexpr double m = 1.0, R = 1.0, g = 9.81, pi = std::numbers::pi, rounding = 1.1e-16;
constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

Bead::Precomputed turning_at(double omega) { return Bead::precompute({.omega = omega}); }

/// What would have to hold the bead still on the hoop: minus its generalised force.
double holding(double omega, double theta) {
  Bead::State rest{};
  rest.q.theta = theta;
  Bead::GeneralizedForces forces{};
  Bead::bias(turning_at(omega), rest, forces);
  return forces.theta;
}

/// K / M at rest on the hoop: the square of the frequency of small oscillations where it is positive.
double squared_frequency(double omega, double theta) {
  Bead::State rest{};
  rest.q.theta = theta;
  Bead::Linearisation linear{};
  EXPECT_EQ(Bead::linearisation(turning_at(omega), rest, {}, {}, {}, linear), torsor::Status::ok);
  return linear.K[0] / linear.M[0];
}

// Relative equilibria: sin(theta) (omega² cos(theta) - g/R) = 0. The forces are below 40 N m: ten roundings.
TEST(BeadOnHoop, RestsAtTheBottomTheTopAndAboveACriticalSpeedAside) {
  for (const double omega : {1.0, 3.0, 3.14, 5.0, 6.2}) {
    EXPECT_NEAR(holding(omega, 0.0), 0.0, 10 * 40 * rounding);
    EXPECT_NEAR(holding(omega, pi), 0.0, 10 * 40 * rounding);
    int roots = 0;  // strictly between bottom and top: by changes of sign
    for (int i = 1; i < 1000; ++i) {
      if ((holding(omega, pi * i / 1000.0) < 0.0) != (holding(omega, pi * (i + 1) / 1000.0) < 0.0) && i < 999) ++roots;
    }
    EXPECT_EQ(roots, omega > 3.132091952673165 ? 1 : 0) << omega;
    if (roots == 1) {
      EXPECT_NEAR(holding(omega, std::acos(g / (R * omega * omega))), 0.0, 10 * 40 * rounding);
    }
  }
}

// A pitchfork at sqrt(g/R) = 3.132091952673165053927326 rad/s: the bottom, stable below it, hands its stability on to
// the pair that is born there. -(U + T0) has the curvature m R² times what is below; all of 25 1/s² at most, ten
// roundings.
TEST(BeadOnHoop, ExchangesStabilityAtTheCriticalSpeed) {
  constexpr double critical = 3.132091952673165053927326, tolerance = 10 * 40 * rounding;
  EXPECT_NEAR(squared_frequency(critical, 0.0), 0.0, tolerance);
  EXPECT_NEAR(std::sqrt(squared_frequency(2.0, 0.0)), 2.410394158638789930968615, tolerance);
  EXPECT_NEAR(std::sqrt(squared_frequency(5.0, 1.167556903805042963872909)), 4.598973363697598107670683, tolerance);
  for (const double omega : {1.0, 3.13, 3.14, 5.0, 8.0}) {
    EXPECT_NEAR(squared_frequency(omega, 0.0), g / R - omega * omega, 10 * 64 * rounding);
    EXPECT_LT(squared_frequency(omega, pi), 0.0);
    if (omega < critical) continue;
    const double aside = std::acos(g / (R * omega * omega));
    EXPECT_LT(squared_frequency(omega, 0.0), 0.0);
    EXPECT_NEAR(squared_frequency(omega, aside), std::pow(omega * std::sin(aside), 2), 10 * 64 * rounding);
  }
}

// Independent truth, 25 digits, of theta'' = sin(theta) (25 cos(theta) - g), theta(0) = 0.1 at rest.
TEST(BeadOnHoop, MeetsItsIndependentReference) {
  const auto row = examples::reference_digits("bead_on_hoop", "10");
  ASSERT_EQ(row.size(), 2U);
  examples::expect_digits(row[0], "0.3975044493306427204705871", 1e-24, "theta");
  examples::expect_digits(row[1], "1.437218743409949773172853", 1e-23, "theta'");
  const auto motion = equations_of_motion<Bead>();
  State y = motion.initial();
  const auto result = integrate(motion, y, 0.0, 10.0, precise);
  ASSERT_TRUE(result) << describe(result);
  // Errors of 1e-13 (1 + |y|), |y| below 3.4, at each step, each grown as much as one made at the start.
  const double local = 1e-13 * 4.4 * static_cast<double>(result.statistics.accepted);
  const double allowed = local * examples::amplification(motion, motion.initial(), 0.0, 10.0);
  EXPECT_NEAR(y[0], 0.3975044493306427204705871, allowed);
  EXPECT_NEAR(y[1], 1.437218743409949773172853, allowed);
}

// Moment of momentum about the axis m R² sin²(theta) omega: its rate is the motor's torque, and the energy is what the
// motor gives. T2 - T0 - U stays.
TEST(BeadOnHoop, TakesItsEnergyFromTheMotor) {
  const auto torque = [](const Bead::State& s) {
    return 2.0 * m * R * R * 5.0 * std::sin(s.q.theta) * std::cos(s.q.theta) * s.v.theta;
  };
  for (int i = 0; i < 20; ++i) {
    Bead::State s{};
    s.q.theta = 0.3 * i - 3.0;
    s.v.theta = 2.0 - 0.2 * i;
    Bead::Reactions reactions{};
    Bead::reactions(turning_at(5.0), s, {0.7}, {}, {}, reactions);
    EXPECT_NEAR(reactions.motor, torque(s), 10 * 20 * rounding);
  }
  const auto motion = equations_of_motion<Bead>();
  const auto balance = examples::energy_balance<Bead>(
      motion, 10.0, 1e-12,
      [&](const Bead::State& s, const Bead::Accelerations&, const Bead::Multipliers&) { return 5.0 * torque(s); });
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-6);
  EXPECT_GT(balance.work, 10.0);  // while T - U alone is far from conserved
  Bead::FirstIntegrals first{}, last{};
  Bead::first_integrals(motion.precomputed(), Bead::initial_state(), first);
  const State y = examples::state_at(motion, motion.initial(), 0.0, 10.0, precise);
  Bead::first_integrals(motion.precomputed(), unpack<Bead>(10.0, y), last);
  static_assert(Bead::first_integral_count == 1);
  EXPECT_NEAR(last[0], first[0], balance.allowed);
}

}  // namespace
}  // namespace torsor::bead_on_hoop_test
