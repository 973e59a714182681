// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "generated/rimless_wheel.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::rimless_wheel_test {
namespace {

using namespace torsor::runtime;
using Wheel = MechanismWithContacts<rimless_wheel::Mechanism<double>>;

// The values of the scene.
constexpr double m = 2, J = 0.5, l = 1, g = 9.81, half = std::numbers::pi / 6;
// Rates after a step: ω² loses its part 1 - μ² in a step and wins 4 m g l sin α sin γ/(J + m l²) between two.
const double mu = (J + m * l * l * std::cos(2 * half)) / (J + m * l * l);
double won(double slope) { return 4 * m * g * l * std::sin(half) * std::sin(slope) / (J + m * l * l); }

TEST(RimlessWheel, StepsAsTheReturnMapSaysToItsLimitCycle) {
  for (const double slope : {0.15, 0.2}) {
    for (const double start : {1.3, 1.7}) {
      const Wheel wheel({.slope = slope, .f = 1});
      Wheel::State y = wheel.initial();
      for (std::size_t i = Wheel::nq; i < y.size(); ++i) y[i] *= start;
      std::vector<double> rates;
      const auto result = integrate_contacts(wheel, y, 0, 12,
                                             DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13},
                                             {}, [&](const ContactEvent& event) {
                                               if (event.kind == ContactEventKind::impact)
                                                 rates.push_back(event.state[5]);
                                               return true;
                                             });
      ASSERT_TRUE(result) << describe(result.status);
      EXPECT_EQ(result.ambiguous, 0);
      EXPECT_LE(result.worst_residual, 1e-13);
      ASSERT_GE(rates.size(), 8U);
      // Steps of 1e-13 of an unstable fall from each foot, which e^(sqrt(m g l/(J + m l²)) T) raises, T below 2 s.
      const double allowed = 1e-9;
      double before = start;
      for (const double rate : rates) {
        EXPECT_NEAR(rate, mu * std::sqrt(before * before + won(slope)), allowed);
        before = rate;
      }
      EXPECT_NEAR(rates.back(), mu * std::sqrt(won(slope) / (1 - mu * mu)),
                  allowed + 3 * std::pow(mu * mu, static_cast<double>(rates.size())));
    }
  }
}

// On the slope of the scene it does not come over the first foot. Its bounces from foot to foot end in rest whatever their
// errors: what the last one leaves of a slip is none.
TEST(RimlessWheel, ComesToRestAtAnyTolerance) {
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const Wheel wheel;
    Wheel::State y = wheel.initial();
    const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
    const auto result = integrate_contacts(wheel, y, 0, 3, method, {.event_limit = 1000});
    ASSERT_TRUE(result) << describe(result.status) << " at " << result.time << " for " << tolerance;
    for (std::size_t i = Wheel::nq; i < y.size(); ++i) EXPECT_NEAR(y[i], 0, 1e-15);
  }
}

// On too gentle a slope it falls back from the top of a step: it rocks and comes to rest on two feet.
TEST(RimlessWheel, RestsOnTwoFeetWhereTheSlopeIsTooGentle) {
  const Wheel wheel({.slope = 0.02, .f = 1});
  Wheel::State y = wheel.initial();
  const auto result = integrate_contacts(wheel, y, 0, 10);
  ASSERT_TRUE(result) << describe(result.status);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(y[3 + i], 0, 1e-9) << i;
  EXPECT_NEAR(std::abs(std::remainder(y[2], 2 * half)), 0, 1e-9);
}

}  // namespace
}  // namespace torsor::rimless_wheel_test
