// SPDX-License-Identifier: GPL-3.0-or-later
// Two rods on pivots: the tip of the first slides on the line of the second. Where both lie on the line of the pivots the tip
// moves along the normal only, whatever the velocities: its slip passes zero there, and no force along the line moves a rod.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/told_motion.hpp"

namespace levers_test {
namespace {

using namespace told_motion;
using Levers = ByHand<2, 2, 1>;
constexpr double length = 0.5, apart = 0.3, mass = 1;

/// q = angles from the vertical towards x, of rods on the pivots x = 0 and x = `apart`.
Levers levers(double f, double e) {
  return {{ContactRule{.tangents = 1, .friction = f, .restitution = e}}, [](double, const auto& y, auto& r) {
            const double a = y[0], b = y[1], da = y[2], db = y[3];
            const Eigen::Vector2d n(-std::cos(b), std::sin(b)), along(std::sin(b), std::cos(b));
            const Eigen::Vector2d tip(length * std::sin(a), length * std::cos(a)), turned(tip.y(), -tip.x());
            const Eigen::Vector2d off = tip - Eigen::Vector2d(apart, 0);
            r.M = Eigen::Matrix2d::Identity() * (mass * length * length / 3);
            r.F << mass * g * length / 2 * std::sin(a), mass * g * length / 2 * std::sin(b);
            r.gap[0] = n.dot(off);
            r.J << n.dot(turned), along.dot(off), along.dot(turned), -r.gap[0];
            r.w << r.J(0, 0) * da + r.J(0, 1) * db, r.J(1, 0) * da + r.J(1, 1) * db;
            r.drift << (db * r.J(1, 0) - da * n.dot(tip)) * da + r.w(1) * db,
                (-db * r.J(0, 0) - da * along.dot(tip)) * da - r.w(0) * db;
          }};
}

double energy(const Levers::State& y) {
  return mass * length * length / 6 * (y[2] * y[2] + y[3] * y[3]) + mass * g * length / 2 * (std::cos(y[0]) + std::cos(y[1]));
}

constexpr Levers::State start{0.1, 0, 0, 0};

/// The states before and after the end of the slip.
struct AtSlipEnd {
  int ends = 0;
  std::array<double, 4> before{}, after{};
  void operator()(const ContactEvent& event) {
    if (event.kind != ContactEventKind::slip_ends) return;
    ++ends;
    std::copy_n(event.before.begin(), 4, before.begin());
    std::copy_n(event.state.begin(), 4, after.begin());
    EXPECT_EQ(event.contacts[0].regime, ContactRegime::slides);
    EXPECT_EQ(event.verdict, ContactVerdict::unique);
  }
};

// What takes a velocity away there takes a rounding over a rounding of it: the rods stopped dead, 4.5 J lost without a word.
TEST(Levers, KeepTheirVelocitiesWhereTheSlipOfTheirContactPassesZero) {
  const Levers system = levers(0.2, 0.1);
  Levers::State y = start;
  AtSlipEnd at;
  const ContactResult result = integrate_contacts(system, y, 0, 0.82, precise, {}, at);
  ASSERT_TRUE(result) << describe(result.status);
  ASSERT_EQ(at.ends, 1);
  // The slip passes zero with some 10 m/s², and is located where it is some 10⁻¹⁵ m/s.
  EXPECT_NEAR(at.before[0], std::numbers::pi / 2, 1e-14);
  EXPECT_NEAR(at.before[1], std::numbers::pi / 2, 1e-14);
  for (std::size_t i = 2; i < 4; ++i) EXPECT_NEAR(at.after[i], at.before[i], 1e-13);  // what is left of w_N, a rounding
}

// Beyond, N falls and the tip leaves the line: a bound of N in the unit of a row that vanishes held it there, pulling.
TEST(Levers, PartWhereTheirContactNoLongerPresses) {
  const Levers system = levers(0.2, 0.1);
  Levers::State y = start;
  Motion motion = move(system, y, 0.9);
  ASSERT_EQ(motion.all(ContactEventKind::opens).size(), 1U);
  const double left = energy(y);
  EXPECT_NEAR(energy({motion.events.back().state[0], motion.events.back().state[1], motion.events.back().state[2],
                      motion.events.back().state[3]}), left, 1e-12);  // in flight none is lost
  EXPECT_GT(y[1], y[0]);
  // Steps that are eight times as short come at least twice as near: impacts cost a step each.
  const auto error = [&](long steps) {
    Levers::State stepped = start;
    EXPECT_EQ(step_contacts(system, stepped, 0, 0.9, {.count = steps}), ContactStatus::reached_end);
    double most = 0;
    for (std::size_t i = 0; i < y.size(); ++i) most = std::max(most, std::abs(stepped[i] - y[i]));
    return most;
  };
  EXPECT_LE(error(16000), error(2000) / 2);
}

// Without friction no energy is lost after the impact, whatever is told of slips that pass zero.
TEST(Levers, PassTheLineOfTheirPivotsWithoutFriction) {
  const Levers system = levers(0, 0);
  Levers::State y = start;
  const Motion motion = move(system, y, 0.82);
  ASSERT_EQ(motion.all(ContactEventKind::impact).size(), 1U);
  const auto& s = motion.events[0].state;
  EXPECT_NEAR(energy(y), energy({s[0], s[1], s[2], s[3]}), 1e-11);  // some 50 steps within 1e-13 of 5 J each
}

}  // namespace
}  // namespace levers_test
