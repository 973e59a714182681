// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/simple_systems.hpp"

namespace rolling_resistance_test {
namespace {

using namespace simple_systems;

constexpr double m = 0.17, R = 0.028575, f = 0.2, h = 5e-4, k = 2e-4;
constexpr DormandPrince853 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

struct Moment { ContactEventKind kind; int contact; double time; std::vector<double> y; double residual; };

template <class S>
std::vector<Moment> events_of(const S& system, typename S::State& y, double end) {
  std::vector<Moment> events;
  const auto log = [&](const ContactEvent& e) {
    events.push_back({e.kind, e.contact, e.time, {e.state.begin(), e.state.end()}, e.residual});
  };
  const ContactResult result = integrate_contacts(system, y, 0, end, precise, {}, log);
  EXPECT_TRUE(result) << describe(result.status);
  EXPECT_LE(result.worst_residual, 1e-13);
  return events;
}

const Moment& the(const std::vector<Moment>& events, ContactEventKind kind, int contact) {
  for (const Moment& each : events) {
    if (each.kind == kind && each.contact == contact) return each;
  }
  ADD_FAILURE() << "no such event of contact " << contact;
  return events.at(0);
}

// billiard_cue_masse.md, B: the ball slides, rolls on, spins out and rests.
TEST(RollingResistance, BringsABilliardBallToRest) {
  const auto ball = ball_on_soft_table(m, R, f, 0, h, k);
  std::array<double, 9> y{0, 0, R, 2, 0, 0, 0, 52.4934383202099737532808399, -69.99125109361329833770778653};
  const auto events = events_of(ball, y, 16);
  const Moment& rolls = the(events, ContactEventKind::slip_ends, 0);
  EXPECT_NEAR(rolls.time, 0.07766548558051587005524645644, 1e-13);
  EXPECT_NEAR(rolls.y[0], 0.149413650135933110629547259, 1e-13);
  EXPECT_NEAR(rolls.y[3], 1.847620317291027862951606452, 1e-13);
  EXPECT_NEAR(rolls.y[7], 1.847620317291027862951606452 / R, 1e-12 * 65);
  const Moment& spun = the(events, ContactEventKind::slip_ends, 2);
  EXPECT_NEAR(spun.time, 11.65137614678899082568807339, 1e-12);
  // It is there with a speed of a rounding, and rests then for good.
  const Moment& rests = the(events, ContactEventKind::slip_ends, 1);
  EXPECT_NEAR(rests.time, 15.14678899082568807339449541, 1e-12);
  EXPECT_NEAR(y[0], 14.07042302616531863029883477, 1e-12);
  for (std::size_t i = 3; i < 9; ++i) EXPECT_NEAR(y[i], 0, 1e-13);
}

// Without resistance the same stroke rolls on with 13/7 of a metre a second.
TEST(RollingResistance, OfNothingChangesNothing) {
  const auto ball = ball_on_soft_table(m, R, f, 0, 0, 0);
  std::array<double, 9> y{0, 0, R, 2, 0, 0, 0, 52.4934383202099737532808399, -69.99125109361329833770778653};
  const auto events = events_of(ball, y, 0.2);
  const Moment& rolls = the(events, ContactEventKind::slip_ends, 0);
  EXPECT_NEAR(rolls.time, 0.07281199941750400465996796272, 1e-14);
  EXPECT_NEAR(rolls.y[0], 0.1404231417337573232727953567, 1e-14);
  EXPECT_NEAR(y[3], 13.0 / 7, 1e-14);
  EXPECT_NEAR(y[7], 64.99187601549806274215723035, 1e-12);
  EXPECT_EQ(y[8], -69.99125109361329833770778653);
}

// A spin that nothing resists passes zero as often as a small torque turns it round: no event, and no force.
TEST(RollingResistance, OfNothingEndsNoSpin) {
  constexpr double torque = 1e-5, rate = 40, I = 0.4 * m * R * R;
  auto ball = ball_on_soft_table(m, R, f, 0, h, 0);
  const auto still = ball.fill;
  ball.fill = [still](double t, const auto& y, ContactReading& r) {
    still(t, y, r);
    r.F(5) += torque * std::cos(rate * t);
  };
  std::array<double, 9> y{0, 0, R, 0, 0, 0, 0, 0, 0};
  EXPECT_TRUE(events_of(ball, y, 1).empty());
  EXPECT_NEAR(y[8], torque / (I * rate) * std::sin(rate), 1e-12);
}

// A disc stays on a slope up to tan a = h/R, and rolls beyond with 2/3 (g sin a - h/R g cos a).
TEST(RollingResistance, HoldsADiscOnASlopeUpToItsAngle) {
  constexpr double radius = 0.1, length = 0.01;
  for (const double tangent : {0.0999999, 0.1000001, 0.2}) {
    const double slope = std::atan(tangent);
    std::array<double, 6> y{0, radius, 0, 0, 0, 0};
    events_of(disc_on_soft_slope(slope, 0.5, radius, length), y, 1);
    const double a = std::max(0.0, 2.0 / 3 * g * (std::sin(slope) - length / radius * std::cos(slope)));
    EXPECT_NEAR(y[3], a, 1e-13) << tangent;
    EXPECT_NEAR(y[0], a / 2, 1e-13) << tangent;
  }
}

// A disc on a level floor is pulled by a force that grows, p t: it begins to roll where p t R = h N, and goes on with
// (p t - h N/R) 2/3.
TEST(RollingResistance, BeginsToRollWhereTheMomentReachesItsBound) {
  constexpr double radius = 0.1, length = 0.01, pull = 2;
  auto disc = disc_on_soft_slope(0, 0.5, radius, length);
  const auto still = disc.fill;
  disc.fill = [still](double t, const auto& y, ContactReading& r) {
    still(t, y, r);
    r.F(0) += pull * t;
  };
  std::array<double, 6> y{0, radius, 0, 0, 0, 0};
  const auto events = events_of(disc, y, 1);
  const double onset = length * g / (radius * pull), later = 1 - onset;
  EXPECT_NEAR(the(events, ContactEventKind::slips, 1).time, onset, 1e-12);
  EXPECT_NEAR(y[3], 2.0 / 3 * pull * later * later / 2, 1e-12);
}

// Thrown up a slope that is steep enough it comes back, on one that is not it stays where it stops.
TEST(RollingResistance, TurnsRoundOrStays) {
  constexpr double radius = 0.1, length = 0.01;
  for (const double tangent : {0.05, 0.2}) {
    const double slope = std::atan(tangent), s = std::sin(slope), c = std::cos(slope);
    std::array<double, 6> y{0, radius, 0, -1, 0, -1 / radius};
    events_of(disc_on_soft_slope(slope, 0.5, radius, length), y, 3);
    const double up = 2.0 / 3 * g * (s + length / radius * c), down = 2.0 / 3 * g * (s - length / radius * c);
    const double turn = 1 / up, left = std::max(0.0, down) * (3 - turn);
    EXPECT_NEAR(y[3], left, 1e-12) << tangent;
    EXPECT_NEAR(y[0], -0.5 / up + left * (3 - turn) / 2, 1e-12) << tangent;
  }
}

// At an impact the moment is bounded by h times the impulse, whatever the law of the impact.
TEST(RollingResistance, TakesOfASpinAtAnImpact) {
  for (const ImpactLaw law : {ImpactLaw::newton_moreau, ImpactLaw::poisson, ImpactLaw::sequential}) {
    for (const double spin : {100.0, 1.0}) {
      const auto ball = ball_on_soft_table(m, R, 0, 0.5, h, k);
      std::array<double, 9> y{0, 0, R, 0, 0, -3, 0, spin, -spin};
      ContactOptions options;
      options.law = law;
      ASSERT_TRUE(integrate_contacts(ball, y, 0, 1e-6, precise, options));
      const double P = 1.5 * m * 3, I = 0.4 * m * R * R;
      EXPECT_NEAR(y[5], 1.5 - g * 1e-6, 1e-14);
      EXPECT_NEAR(y[7], std::max(0.0, spin - h * P / I), 1e-12);
      EXPECT_NEAR(y[8], -std::max(0.0, spin - k * P / I), 1e-12);
    }
  }
}

// The scheme by steps tends to the same motion.
TEST(RollingResistance, IsTheSameByStepsThatShrink) {
  const auto ball = ball_on_soft_table(m, R, f, 0, h, k);
  const std::array<double, 9> start{0, 0, R, 2, 0, 0, 0, 52.4934383202099737532808399, -69.99125109361329833770778653};
  auto exact = start;
  ASSERT_TRUE(integrate_contacts(ball, exact, 0, 1, precise));
  const auto error = [&](long steps) {
    auto y = start;
    EXPECT_EQ(step_contacts(ball, y, 0, 1, {.count = steps}), ContactStatus::reached_end);
    return std::abs(y[0] - exact[0]) + std::abs(y[3] - exact[3]);
  };
  const double coarse = error(100), fine = error(1000);
  EXPECT_LT(coarse, 0.1);
  EXPECT_LT(fine, coarse / 5);
}

}  // namespace
}  // namespace rolling_resistance_test
