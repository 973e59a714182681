// SPDX-License-Identifier: GPL-3.0-or-later
// A bar on two rough points: how they share friction is not unique. It rests as long as any sharing holds it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/contacts/told_motion.hpp"

namespace shared_friction_test {
namespace {

using namespace told_motion;

// A bar of mass 1 on points at its ends, 1 m from its middle, with bounds of friction; its middle is pulled by a force t at
// an angle from the bar. q = (x, y, φ).
ByHand<3, 3, 2> bar(double bound, double other_bound, double angle) {
  return {{ContactRule{.tangents = 2, .normal = false, .bound = bound},
           ContactRule{.tangents = 2, .normal = false, .bound = other_bound}},
          [=](double t, const auto& y, auto& r) {
            const double c = std::cos(y[2]), s = std::sin(y[2]), turning = y[5], square = turning * turning;
            r.M.setIdentity();
            r.M(2, 2) = 1.0 / 3;
            r.F << t * std::cos(angle), t * std::sin(angle), 0;
            r.J << 1, 0, -s, 0, 1, c, 1, 0, s, 0, 1, -c;
            r.w << y[3] - s * turning, y[4] + c * turning, y[3] + s * turning, y[4] - c * turning;
            r.drift << -c * square, -s * square, c * square, s * square;
          }};
}

// Each end takes half of the force across the bar; along it both take what their discs leave.
double slipping_time(double bound, double other_bound, double angle) {
  double low = 0, high = 2 * std::min(bound, other_bound) / std::max(std::sin(angle), 0.1);
  for (int i = 0; i < 100; ++i) {
    const double t = (low + high) / 2, half = t * std::sin(angle) / 2;
    const auto left = [half](double b) { return std::sqrt(std::max(0.0, b * b - half * half)); };
    const bool rests = half <= std::min(bound, other_bound) && t * std::cos(angle) <= left(bound) + left(other_bound);
    (rests ? low : high) = t;
  }
  return low;
}

struct Pull { double bound, other_bound, angle; };

class SharedFriction : public testing::TestWithParam<Pull> {};

TEST_P(SharedFriction, HoldsAsLongAsAnySharingDoes) {
  const auto [bound, other_bound, angle] = GetParam();
  std::array<double, 6> y{};
  const double slips = slipping_time(bound, other_bound, angle);
  const Motion motion = move(bar(bound, other_bound, angle), y, slips + 0.5);
  ASSERT_FALSE(motion.events.empty());
  EXPECT_EQ(motion.events[0].kind, ContactEventKind::slips);
  // Both ends are let go at 4e-12 of the largest force beyond their bounds.
  EXPECT_NEAR(motion.events[0].time, slips, 2 * 4.1e-12 * std::max(bound, other_bound));
  EXPECT_GT(motion.result.indeterminate, 0);
}

INSTANTIATE_TEST_SUITE_P(Pulls, SharedFriction,
                         testing::Values(Pull{1, 3, 0}, Pull{1, 3, 0.3}, Pull{2, 2, 0.5}, Pull{1, 1, 1.5}, Pull{1, 3, 1.2}));

// Both ends slide: a = t - 4 from t = 4 on, along the pull.
TEST(SharedFriction, GivesWayInTheDirectionOfThePull) {
  std::array<double, 6> along{};
  move(bar(1, 3, 0), along, 4.5);
  EXPECT_NEAR(along[0], 0.125 / 6, 1e-11);
  EXPECT_NEAR(along[3], 0.125, 1e-11);
  std::array<double, 6> oblique{};
  const double end = 4.5, c = std::cos(0.5), s = std::sin(0.5);
  move(bar(2, 2, 0.5), oblique, end);
  EXPECT_NEAR(oblique[3], 0.125 * c, 1e-11);
  EXPECT_NEAR(oblique[4], 0.125 * s, 1e-11);
  EXPECT_NEAR(oblique[5], 0, 1e-11);
}

}  // namespace
}  // namespace shared_friction_test
