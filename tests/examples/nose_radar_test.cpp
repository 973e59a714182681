// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/nose_radar.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::nose_radar_test {
namespace {

using namespace torsor::runtime;
using Radar = nose_radar::Mechanism<double>;

// The values of the scene.
constexpr double h = 0.4, a = 0.25, m = 12.0, rounding = 1.1e-16;

auto samples() { return examples::random_samples<Radar>(3); }

struct Angles {
  double ca, sa, cb, sb;
  explicit Angles(const Radar::State& s)
      : ca(std::cos(s.q.alpha)), sa(std::sin(s.q.alpha)), cb(std::cos(s.q.beta)), sb(std::sin(s.q.beta)) {}
};

// By hand: V(G) = v x + (h + a cos(beta)) alpha' y1 - a beta' z2, with y1 = (-sin(alpha), cos(alpha), 0) and
// z2 = sin(beta) x1 + cos(beta) z. Twenty roundings of numbers below 5 (200 m/s at the most are not asked for here).
TEST(NoseRadar, HasTheVelocityOfTheExercise) {
  for (const auto& [s, rates] : samples()) {
    const Angles at(s);
    Radar::Kinematics found{};
    Radar::kinematics(Radar::precompute({}), s, found);
    const double turning = (h + a * at.cb) * s.v.alpha, nodding = -a * s.v.beta;
    const std::array<double, 3> expected{s.v.x - turning * at.sa + nodding * at.sb * at.ca,
                                         turning * at.ca + nodding * at.sb * at.sa, nodding * at.cb};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.antenna_velocity[i], expected[i], 20 * 5 * rounding);
  }
}

// By hand:
// Gamma . x  = v' - sin(alpha) [(h + a cos(beta)) alpha'' - 2 a sin(beta) alpha' beta'] - (h + a cos(beta)) cos(alpha)
//              alpha'^2 - a cos(alpha) (sin(beta) beta'' + cos(beta) beta'^2)
// Gamma . x2 = v' cos(alpha) cos(beta) - (h + a cos(beta)) cos(beta) alpha'^2 - a beta'^2
// Forces of 100 N, thirty roundings.
TEST(NoseRadar, HasTheTwoComponentsOfTheAccelerationOfTheExercise) {
  for (const auto& [s, rates] : samples()) {
    const Angles at(s);
    Radar::Reactions found{};
    Radar::reactions(Radar::precompute({}), s, rates, {}, {}, found);
    const double reach = h + a * at.cb, spin = s.v.alpha, nod = s.v.beta;
    const double along_x = rates.x - at.sa * (reach * rates.alpha - 2.0 * a * at.sb * spin * nod) -
                           reach * at.ca * spin * spin - a * at.ca * (at.sb * rates.beta + at.cb * nod * nod);
    const double along_x2 = rates.x * at.ca * at.cb - reach * at.cb * spin * spin - a * nod * nod;
    EXPECT_NEAR(found.F_x, m * along_x, 30 * 100 * rounding);
    EXPECT_NEAR(found.F_x2, m * along_x2, 30 * 100 * rounding);
  }
}

// The same accelerations by the change of the generated velocity over 2 h of a motion with constant second rates: their
// error is h² times third derivatives of 100, and rounding over h.
TEST(NoseRadar, HasTheRateOfItsVelocityAsAcceleration) {
  constexpr double step = 1e-5;
  for (const auto& [s, rates] : samples()) {
    std::array<Radar::Kinematics, 2> sides{};
    for (const int side : {0, 1}) {
      const double t = side == 0 ? -step : step;
      Radar::State moved = s;
      for (int i = 0; i < 3; ++i) {
        moved.q[i] += s.v[i] * t + rates[i] * t * t / 2.0;
        moved.v[i] += rates[i] * t;
      }
      Radar::kinematics(Radar::precompute({}), moved, sides[static_cast<std::size_t>(side)]);
    }
    std::array<double, 3> acceleration{};
    for (std::size_t i = 0; i < 3; ++i) {
      acceleration[i] = (sides[1].antenna_velocity[i] - sides[0].antenna_velocity[i]) / (2.0 * step);
    }
    const Angles at(s);
    Radar::Reactions found{};
    Radar::reactions(Radar::precompute({}), s, rates, {}, {}, found);
    const double along_x2 = (acceleration[0] * at.ca + acceleration[1] * at.sa) * at.cb - acceleration[2] * at.sb;
    EXPECT_NEAR(found.F_x / m, acceleration[0], 1e-8);
    EXPECT_NEAR(found.F_x2 / m, along_x2, 1e-8);
  }
}

// Thrust and motors at work; T has 9000 kg at 200 m/s.
TEST(NoseRadar, ObeysTheEnergyTheoremWithItsMotors) {
  const auto law = [](const Radar::State& s) { return Radar::Inputs{5000.0, 0.5 * std::cos(s.time), -0.3 * s.v.beta}; };
  const auto motion = equations_of_motion<Radar>(Radar::default_parameters(), law);
  const auto balance = examples::energy_balance<Radar>(motion, 2.0, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 2.0);  // a relative 1e-12 of 400 m at each of some 50 steps, with m V = 2e6 N s
  EXPECT_GT(balance.work, 1e6);
}

}  // namespace
}  // namespace torsor::nose_radar_test
