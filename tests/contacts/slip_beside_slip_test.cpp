// SPDX-License-Identifier: GPL-3.0-or-later
// A slip that begins beside another one, which turns by its own velocity as it fades.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/contacts/told_motion.hpp"

namespace slip_beside_slip_test {
namespace {

using namespace told_motion;

struct Pull {
  double bound, other_bound, x, y, moment;
};

/// A bar of mass 1 on points 1 m from its middle, with bounds of friction: q = (x, y, φ).
ByHand<3, 3, 2> bar(const Pull& pull) {
  return {{ContactRule{.tangents = 2, .normal = false, .bound = pull.bound},
           ContactRule{.tangents = 2, .normal = false, .bound = pull.other_bound}},
          [=](double, const auto& y, auto& r) {
            const double c = std::cos(y[2]), s = std::sin(y[2]), turning = y[5], square = turning * turning;
            r.M.setIdentity();
            r.M(2, 2) = 1.0 / 3;
            r.F << pull.x, pull.y, pull.moment;
            r.J << 1, 0, -s, 0, 1, c, 1, 0, s, 0, 1, -c;
            r.w << y[3] - s * turning, y[4] + c * turning, y[3] + s * turning, y[4] - c * turning;
            r.drift << -c * square, -s * square, c * square, s * square;
          }};
}

/// Both slide against their velocities: rates of (x', y', φ') of a bar that has not moved yet.
struct Slides {
  Pull pull;
  Evaluation operator()(double, const std::array<double, 3>& v, std::array<double, 3>& rates) const {
    const double up = v[1] + v[2], down = v[1] - v[2];
    const double one = pull.bound / std::hypot(v[0], up), other = pull.other_bound / std::hypot(v[0], down);
    rates = {pull.x - (one + other) * v[0], pull.y - one * up - other * down, 3 * (pull.moment - one * up + other * down)};
    return Evaluation::ok;
  }
};

/// The direction in which the first point begins to slide: that of its acceleration there, which friction against it gives.
std::array<double, 2> beginning(const Pull& pull, double speed) {
  const auto across = [&](double angle) {
    std::array<double, 3> rates{};
    const double c = std::cos(angle), s = std::sin(angle), least = 1e-14;
    (void)Slides{pull}(0, {least * c, -speed + least * s / 2, speed + least * s / 2}, rates);
    return c * (rates[1] + rates[2]) - s * rates[0];
  };
  // What acts without its own friction gives nearly that direction.
  const double without = std::atan2(pull.y + 3 * pull.moment - 2 * pull.other_bound, pull.x);
  double low = without - 0.7, high = without + 0.7;
  EXPECT_LT(across(low) * across(high), 0);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (across(middle) * across(low) > 0 ? low : high) = middle;
  }
  return {std::cos(low), std::sin(low)};
}

class SlipBesideSlip : public testing::TestWithParam<Pull> {};

// The second point moves across the bar at 4e-6 m/s, fades and turns towards the pull within a millionth of a second: the
// first one, which began in the direction that this friction gave it, follows. It was taken to turn by forces alone, went on
// across its friction or against it, and crept so for ever at a rate that let steps be no longer than 1e-6 s.
TEST_P(SlipBesideSlip, FollowsItsOwnVelocityWhereTheOtherTurnsQuickly) {
  const Pull pull = GetParam();
  constexpr double speed = 2e-6, end = 1.2e-6, least = 1e-13;
  std::array<double, 6> y{0, 0, 0, 0, -speed, speed};
  const auto result = integrate_contacts(bar(pull), y, 0, end, precise);
  ASSERT_TRUE(result) << describe(result.status);
  const auto d = beginning(pull, speed);
  std::array<double, 3> v{least * d[0], -speed + least * d[1] / 2, speed + least * d[1] / 2};
  ASSERT_TRUE(integrate(Slides{pull}, v, 0.0, end, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-16}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(y[3 + i], v[i], 1e-12) << i;
}

INSTANTIATE_TEST_SUITE_P(Pulls, SlipBesideSlip,
                         testing::Values(Pull{1, 1, 1.6, 0.2, 0}, Pull{1, 1.5, 1.2, -0.8, 0.8}, Pull{1.5, 1, 2, 0.3, 0.1}));

}  // namespace
}  // namespace slip_beside_slip_test
